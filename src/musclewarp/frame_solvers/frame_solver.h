// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/frame_solvers/paper_scene.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/frames/scene_state.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/motion/pose_steps.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

// What keeps muscles out of bones and of each other.
enum class ContactKind {
  kNone,       // nothing: every muscle deforms on its own
  kPaper,      // Kellnhofer and Kohout, section 3
  kCertified,  // no triangles cross, and a certificate proves it
};

// "none", "paper" or "certified": the text of flags and reports.
std::string ToString(ContactKind kind);

struct FrameSolverOptions {
  ContactKind contact = ContactKind::kCertified;
  PreRotationOptions pre_rotation;

  // The options of the paper's contact, and the steps in which it follows a
  // motion.
  PaperSceneOptions paper;
  StepLimits paper_limits;

  // The options of certified contact, and the requirements on its frames.
  CertifiedContactOptions certified;
  FrameRequirements requirements;

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

// Describes the contact of a run, for reports.
struct ContactReport {
  ContactKind kind = ContactKind::kNone;
  std::string name = "none";  // the kind, and its variant: "paper/coarse"

  // True if all muscles are solved together, so that each counts the iterations
  // of all of them.
  bool is_solved_together = false;
  nlohmann::ordered_json options;  // "contact_options" of report.json
  std::vector<std::string> warnings;
  double prepare_ms = 0;

  // The intersections in the rest pose once contact has separated the meshes as
  // they were delivered. Nothing without contact.
  std::optional<SceneIntersections> rest;

  // The muscles, by number, that contact has moved farther in the rest pose
  // than the requirements allow, most likely because a bone or another muscle
  // cuts off a part of them.
  std::vector<int> displaced_at_rest;
};

// A frame, and the state that the next frame starts from.
struct SolvedFrame {
  Frame frame;
  SceneState state;
};

// Moves a prepared scene to poses, with whatever kind of contact. There is one
// implementation for each kind; callers need not know which one they have.
//
//   RestResult rest = SeparateRest({options.certified, ...}, ..., &scene);
//   auto solver = MakeFrameSolver(scene, options, meshes, rest);
//   SceneState state = solver->StartOfMotion(solvers);
//   for (const ScenePose& pose : scene.scene.poses) {
//     SolvedFrame solved = solver->Solve(solvers, pose, &state, {});
//     state = std::move(solved.state);
//   }
class FrameSolver {
 public:
  virtual ~FrameSolver() = default;

  const ContactReport& contact() const { return contact_; }

  // Returns the frame of the scene as it was delivered.
  const Frame& RestFrame();

  // Returns the state that the first frame of a motion starts from.
  virtual SceneState StartOfMotion(const MuscleSolvers& solvers) = 0;

  // Returns in how many steps a pose can be reached from the pose `from` (null:
  // on its own, see Solve) if they are short. Fewer may do, but the time of a
  // frame can be foretold by their number.
  virtual int ExpectedSteps(const ScenePose* from,
                            const ScenePose& pose) const = 0;

  // Moves the muscles to a pose, from their state in the frame before or, if
  // `before` is null, on their own: the frame then does not depend on any other
  // frame. `on_progress` may be empty. The frame is measured and, with
  // certified contact, judged.
  virtual SolvedFrame Solve(const MuscleSolvers& solvers,
                            const ScenePose& pose,
                            const SceneState* before,
                            const ProgressCallback& on_progress) = 0;

 protected:
  FrameSolver(const PreparedScene& scene,
              const FrameSolverOptions& options,
              std::shared_ptr<SceneMeshes> meshes);

  const PreparedScene& scene_;
  const FrameSolverOptions options_;
  const std::shared_ptr<SceneMeshes> meshes_;
  ContactReport contact_;

 private:
  std::optional<Frame> rest_frame_;
};

// Makes the frame solver of a scene for the kind of contact in the options.
// `meshes` are those of the scene, in the rest pose; several frame solvers may
// share them. Keeps a reference to the scene. Certified contact starts from
// `rest`, what SeparateRest() made of an equal scene with equal options; the
// others have no use for it. Preconditions (CHECKed): the options are valid,
// and there is a rest with certified contact.
std::unique_ptr<FrameSolver> MakeFrameSolver(
    const PreparedScene& scene,
    const FrameSolverOptions& options,
    std::shared_ptr<SceneMeshes> meshes,
    std::optional<RestResult> rest = {});

}  // namespace musclewarp
