// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/certified_contact/offset_extension.h"
#include "musclewarp/certified_contact/step.h"
#include "musclewarp/frames/muscle_shapes.h"
#include "musclewarp/frames/plane_rates.h"
#include "musclewarp/initial_separation/initial_separation.h"
#include "musclewarp/motion/pose_steps.h"
#include "musclewarp/motion/recorded_step.h"
#include "musclewarp/motion/solved_pose.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

struct CertifiedContactOptions {
  MuscleSurfaceOptions surface;
  InitialSeparationOptions separation;
  StepOptions step;

  // The coarse solve with contact rows: how many fine vertices of a muscle have
  // a row for each of its coarse vertices, and the weight of a row against a
  // Laplacian row. What the rows do not achieve, as the shape resists, is left
  // to single vertices. Weight 0 leaves out the coarse solve: muscles of the
  // LHDL hip then move half as far on average (0.40 mm instead of 0.83), but
  // more triangles fold. At weight 1 they move twice as far (1.48 mm). With one
  // sample for each coarse vertex they move by 0.56 mm (docs/method.md).
  double samples_per_coarse_vertex = 3;
  double coarse_weight = 0.3;

  // The separated rest pose is relaxed in at most so many steps, until no more
  // than one vertex in five hundred moves by more than the tolerance (mm) in
  // one. It has far to go, so that its steps have more sweeps. Squeezed
  // vertices go on moving by 0.1 mm in every step, but a tolerance of 0.15 mm
  // leaves muscles displaced by more than need be (12.8 instead of 11.1 mm in
  // the originals of the hamstrings).
  int max_rest_steps = 20;
  int rest_sweeps = 30;
  double rest_tolerance = 0.05;

  // A step that cannot be shorter and after which triangles cross is tried
  // again with this many times the reach, up to the limit (mm). One at the pose
  // after which none do, but in which muscles moved by all of the reach, is
  // followed by one with so much more of it.
  double reach_growth = 1.5;
  double max_reach = 4;

  // A pose is reached in steps within these limits. Steps are shorter where
  // contact would push muscles by more than `max_push` in one, mm, but not for
  // that reason shorter than a share of the limits. A muscle that a bone
  // sweeps along is moved by 11 mm in steps of 2 mm as in shorter ones, and by
  // 16 mm in steps of 3 mm (stress_sweep).
  StepLimits limits = {20 * M_PI / 180, 80};
  double max_push = 2;
  double unchecked_fraction = 1.0 / 8;

  // A step after which triangles cross is halved, down to that share halved so
  // many times.
  int max_halvings = 2;

  // Where they cross even then, the scene goes back a few steps, and on by
  // steps of a quarter of the share, and the next time of a sixteenth, so many
  // times: creases form by way of the steps before.
  int max_returns = 2;

  // If muscles are pushed by more than the reach up to the end, they settle in
  // so many steps, until no more than one vertex in five hundred moves by more
  // than the tolerance, mm. Two steps undo most of what long steps displace
  // muscles by too much (thigh, flexion by 45 degrees: 0.12 of 0.16 mm on
  // average).
  int max_settling_steps = 8;
  double settling_tolerance = 0.9;

  // A pose that is not reached in this time is given up, s; 0: no limit. The
  // last step may take longer. A pose that bones cannot take, because the
  // centre of a joint is wrong, would take many minutes without a limit.
  static constexpr double kTimeoutByMuscles = -1;  // 60, and 20 for each muscle
  double frame_timeout_s = kTimeoutByMuscles;

  // Called after every step, those that separate the rest pose included. May be
  // empty.
  StepCallback on_step;

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

// A scene prepared for certified contact, and the state without crossings that
// every motion starts from. Constant once it is prepared.
struct CertifiedScene {
  CertifiedContactOptions options;

  // The muscles in the order of contact, which that of all below is too, and
  // the number of each in the scene. Points into the scene.
  std::vector<const PreparedMuscle*> muscles;
  std::vector<int> order;

  ContactScene contact;

  // The fine vertices of each muscle that may have rows in the coarse solve.
  std::vector<std::vector<int>> samples;

  // The separated rest pose. Attached vertices are where they are in it; their
  // bodies carry them along from there.
  ContactState rest;

  // What attachments make of the shape without contact.
  std::vector<std::shared_ptr<const OffsetExtension>> extensions;
  double wall_ms = 0;
};

// Separates the meshes of a scene and relaxes its rest pose. `meshes` are those
// of the scene, in the rest pose. `on_progress` may be empty. Precondition
// (CHECKed): the options are valid.
CertifiedScene PrepareCertifiedScene(const PreparedScene& scene,
                                     const SceneMeshes& meshes,
                                     const CertifiedContactOptions& options,
                                     const PreRotationOptions& pre_rotation,
                                     const MuscleSolver& solver,
                                     const ProgressCallback& on_progress);

// Puts a scene together whose rest pose has been separated before: `rest` is
// that of an equal CertifiedScene. `meshes` are those of the scene, in the rest
// pose. Precondition (CHECKed): the options are valid.
CertifiedScene RestoreCertifiedScene(const PreparedScene& scene,
                                     const SceneMeshes& meshes,
                                     const CertifiedContactOptions& options,
                                     ContactState rest);

// How a pose was reached.
struct MotionSummary {
  // Of the last step, by muscle, in the order of the scene.
  std::vector<SolverSummary> summaries;
  int steps = 0;  // including those that were given up

  // If the time ran out, the share of the way that was gone by then.
  std::optional<double> timed_out_at;
};

struct CertifiedMotion {
  ContactState state;

  // What the next pose should be reached from: the last state in which nothing
  // crossed, if something does in `state`; else there is none, and it is
  // `state`.
  std::optional<ContactState> last_clean;
  MotionSummary summary;
};

// Moves a scene from `before` to a pose, step by step. If no triangles cross in
// `before`, none do in the result, provided that there is a way. If the
// shortest step still leads to crossings, it is taken all the same: what
// follows may resolve them, and the certificate tells.
CertifiedMotion MoveCertified(const PreparedScene& scene,
                              const CertifiedScene& certified,
                              const ScenePose& pose,
                              const PreRotationOptions& pre_rotation,
                              const MuscleSolver& solver,
                              const ContactState& before,
                              const ProgressCallback& on_progress);

// What a frame shows of a state, in the order of the scene.
MuscleShapes ShapesOf(const CertifiedScene& certified,
                      const ContactState& state);

// Returns the coarse vertices as they would be without contact, in the order of
// the scene, N x 3 each, mm.
std::vector<Points> FreeCoarseOf(const CertifiedScene& certified,
                                 const ContactState& state);

// Returns the rows with which contact had each muscle solved, and what their
// planes go along with, in the order of the scene.
std::vector<ContactRows> ContactRowsOf(const CertifiedScene& certified,
                                       const ContactState& state);

}  // namespace musclewarp
