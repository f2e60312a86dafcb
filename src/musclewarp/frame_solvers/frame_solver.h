// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/frame_solvers/paper_scene.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/frames/scene_state.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/motion/pose_steps.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

// The method that prevents muscles from penetrating bones and each other.
enum class ContactKind {
  kNone,       // no contact: every muscle deforms on its own
  kPaper,      // Kellnhofer and Kohout, section 3
  kCertified,  // no triangles cross, and a certificate proves it
};

// "none", "paper" or "certified": the text of flags and reports.
std::string ToString(ContactKind kind);

// The kind of contact and the options of all frame solvers.
struct FrameSolverOptions {
  ContactKind contact = ContactKind::kCertified;
  PreRotationOptions pre_rotation;

  // The options of the paper's contact, and the limits of its steps in a
  // motion.
  PaperSceneOptions paper;
  StepLimits paper_limits;

  // The options of certified contact, and the requirements on its frames.
  CertifiedContactOptions certified;
  FrameRequirements requirements;

  // What is measured of frames.
  MeasureOptions measures;

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

// Describes the contact of a run, for reports.
struct ContactReport {
  ContactKind kind = ContactKind::kNone;
  std::string name = "none";  // the kind, and its variant: "paper/coarse"

  // True if all muscles are solved together. The iterations of each are then
  // those of the joint solve.
  bool is_solved_together = false;

  // "contact_options" of report.json: of certified contact its gap, mm, of
  // contact as in the paper the others (GroupContactOptions).
  double gap = 0;
  std::string level;
  unsigned seed = 0;

  std::vector<std::string> warnings;
  double prepare_ms = 0;

  // The intersections in the rest pose after contact has separated the
  // delivered meshes. Empty without contact.
  std::optional<SceneIntersections> rest;

  // The indices of the muscles whose displacement by contact in the rest pose
  // exceeds the requirements, most likely because a bone or another muscle cuts
  // off a part of them.
  std::vector<int> displaced_at_rest;
};

// A frame, and the start of the next one.
struct SolvedFrame {
  Frame frame;
  SceneState state;
};

// Moves a prepared scene to poses, independently of the kind of contact: the
// interface of one implementation per kind.
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

  // Returns the frame of the scene as delivered.
  const Frame& RestFrame();

  // Returns the start of the first frame of a motion.
  virtual SceneState StartOfMotion(const MuscleSolvers& solvers) = 0;

  // Returns the number of short steps to a pose from the pose `from` (null: an
  // isolated pose, see Solve). The actual number may be smaller; the estimate
  // serves to predict the time of a frame.
  virtual int ExpectedSteps(const ScenePose* from,
                            const ScenePose& pose) const = 0;

  // Moves the muscles to a pose, from their state in the frame before. If
  // `before` is null, the pose is isolated: its frame is independent of all
  // others. `on_progress` may be empty. The frame is measured and lists its
  // shortcomings, if the kind of contact judges any.
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
// `meshes`: the meshes of the scene, in the rest pose; several frame solvers
// may share them. Keeps a reference to the scene. Certified contact starts from
// `rest`, the result of SeparateRest() for an equal scene and equal options;
// other kinds ignore it. Preconditions (CHECKed): the options are valid, and
// `rest` is given for certified contact.
std::unique_ptr<FrameSolver> MakeFrameSolver(
    const PreparedScene& scene,
    const FrameSolverOptions& options,
    std::shared_ptr<SceneMeshes> meshes,
    std::optional<RestResult> rest = {});

}  // namespace musclewarp
