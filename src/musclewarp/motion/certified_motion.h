// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/progress.h"
#include "musclewarp/certified_contact/offset_extension.h"
#include "musclewarp/certified_contact/step.h"
#include "musclewarp/frames/muscle_shapes.h"
#include "musclewarp/frames/plane_rates.h"
#include "musclewarp/initial_separation/initial_separation.h"
#include "musclewarp/motion/given_up.h"
#include "musclewarp/motion/pose_steps.h"
#include "musclewarp/motion/recorded_step.h"
#include "musclewarp/motion/solved_pose.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

// Options of certified contact: of the separation of the rest pose and of the
// motion from pose to pose.
struct CertifiedContactOptions {
  MuscleSurfaceOptions surface;
  InitialSeparationOptions separation;
  StepOptions step;

  // Meshes that overlap are separated by so many gaps, so that the steps that
  // follow find room. This gives the margin of medial cells, whatever
  // `separation` has.
  double margin_in_gaps = 2;

  // Returns the options of the separation with that margin.
  InitialSeparationOptions SeparationByGap() const;

  // The coarse solve with contact rows: the number of sampled fine vertices per
  // coarse vertex, of which those near a plane get a row, and the weight of a
  // row relative to a Laplacian row. The offsets of fine vertices resolve any
  // contact that the coarse solve leaves. Weight 0 disables the coarse solve:
  // muscles of the LHDL hip then move half as far on average (0.40 mm instead
  // of 0.83), but more triangles fold. At weight 1 they move twice as far (1.48
  // mm). With one sample per coarse vertex they move by 0.56 mm
  // (docs/method.md).
  double samples_per_coarse_vertex = 3;
  double coarse_weight = 0.3;

  // The separated rest pose is relaxed in at most `max_rest_steps` steps, until
  // every muscle has settled: a step moves at most one in five hundred of its
  // vertices by the tolerance (mm), or it moves to and fro (SettlingMuscles).
  // Vertices start far from equilibrium, so these steps take more sweeps.
  int max_rest_steps = 60;
  int rest_sweeps = 30;
  double rest_volume_move = 1;  // VolumeOptions::max_move, mm
  double rest_tolerance = 0.1;

  // A step of the shortest length that leaves crossing triangles is retried
  // with the reach multiplied by `reach_growth`, up to `max_reach` (mm). The
  // same applies to the step after a settling step without defects that moved
  // muscles by more than the reach.
  double reach_growth = 1.5;
  double max_reach = 4;

  // A motion is divided into steps within these limits. Steps are shortened
  // where contact would push muscles by more than `max_push` (mm) in one step,
  // but not below the fraction `unchecked_fraction` of the limits. A muscle
  // swept along by a bone is displaced by 11 mm with steps of 2 mm as with
  // shorter ones, and by 16 mm with steps of 3 mm (stress_sweep).
  StepLimits limits = {RadiansOf(20), 80};
  double max_push = 2;
  double unchecked_fraction = 1.0 / 8;

  // A step that leaves crossing triangles is halved, at most `max_halvings`
  // times below `unchecked_fraction`.
  int max_halvings = 2;

  // If triangles cross even after the shortest step, the solver backtracks a
  // few steps and continues with steps of a quarter of `unchecked_fraction`,
  // the next time of a sixteenth, at most `max_returns` times: creases form
  // over several steps.
  int max_returns = 2;

  // If contact still pushes muscles by the reach in the last step, settling
  // steps follow at the pose, at most `max_settling_steps`, until all muscles
  // have settled within the tolerance (mm). Two steps undo most of the excess
  // displacement of long steps (thigh, flexion by 45 degrees: 0.12 of 0.16 mm
  // on average).
  int max_settling_steps = 8;
  double settling_tolerance = 0.9;

  // The tolerance of Settling::kFully, mm.
  double full_settling_tolerance = 0.1;

  // After so many steps in a row that leave crossing triangles, the remainder
  // of the motion is computed without contact; 0: no limit. Once the solver has
  // backtracked, they are a sixteenth of the unchecked length, 32 of them a
  // quarter of the longest one. On the long way to an anatomically impossible
  // pose, as with a wrong joint centre, there would be hundreds without a
  // limit.
  int max_stuck_steps = 32;

  // The same after this time (s), in place of that number; 0: neither. The step
  // in progress is completed first. What a frame is then depends on how fast
  // and how busy the machine is.
  static constexpr double kNoClock = -1;
  double frame_timeout_s = kNoClock;

  // Called after every step, including those that relax the rest pose. May be
  // empty.
  StepCallback on_step;

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

// A scene prepared for certified contact: its surfaces, their search trees and
// the intersection-free rest pose, in which every motion starts. Constant after
// preparation.
struct CertifiedScene {
  CertifiedContactOptions options;

  // The muscles in the order of contact, which all members below share, and the
  // index of each in the scene. Points into the scene.
  std::vector<const PreparedMuscle*> muscles;
  std::vector<int> order;

  ContactScene contact;

  // The fine vertices of each muscle that may get rows in the coarse solve, and
  // the weight of its rows.
  std::vector<std::vector<int>> samples;
  std::vector<double> row_weights;

  // The separated rest pose. Attached vertices move rigidly with their bodies
  // from their positions in it.
  ContactState rest;

  // Extend the offsets of attached vertices to each muscle, as without contact.
  std::vector<std::shared_ptr<const OffsetExtension>> extensions;
  double wall_ms = 0;
};

// Separates the meshes of a scene and relaxes its rest pose. `meshes`: the
// meshes of the scene, in the rest pose. `on_progress` may be empty. Throws
// InputError if a mesh needs too much memory (CheckContactFits). `cells`: see
// SeparateInitially. Precondition (CHECKed): the options are valid.
CertifiedScene PrepareCertifiedScene(const PreparedScene& scene,
                                     const SceneMeshes& meshes,
                                     const CertifiedContactOptions& options,
                                     const PreRotationOptions& pre_rotation,
                                     const MuscleSolver& solver,
                                     const ProgressCallback& on_progress,
                                     KnownCells* cells = nullptr);

// Relaxes a rest pose that is separated, with another triangulation of its
// meshes: `start` has the muscles in it, in the order of the scene.
// Preconditions: the options are valid (CHECKed), and nothing crosses in
// `start`.
CertifiedScene RelaxCertifiedScene(const PreparedScene& scene,
                                   const CertifiedContactOptions& options,
                                   const PreRotationOptions& pre_rotation,
                                   const MuscleSolver& solver,
                                   const MuscleShapes& start,
                                   const ProgressCallback& on_progress);

// Rebuilds a CertifiedScene from its rest pose: `rest` is that of an equal
// CertifiedScene. `meshes`: the meshes of the scene, in the rest pose.
// Precondition (CHECKed): the options are valid.
CertifiedScene RestoreCertifiedScene(const PreparedScene& scene,
                                     const CertifiedContactOptions& options,
                                     ContactState rest);

// The outcome of a motion to one pose.
struct MotionSummary {
  // The solves of the last step, by muscle, in the order of the scene.
  std::vector<SolverSummary> summaries;
  int steps = 0;  // including rejected ones

  double reached = 1;  // the fraction of the motion, with contact
  GivenUp given_up = GivenUp::kNot;
};

// The state after a motion, and the start of the next one.
struct CertifiedMotion {
  ContactState state;

  // The start of the next motion, if not `state`: the last state without
  // crossing triangles, if `state` has some or the motion was given up.
  std::optional<ContactState> last_clean;
  MotionSummary summary;
};

// When muscles settle at the end of a motion.
enum class Settling {
  kIfPushed,  // those that contact pushes by the reach, roughly
  kFully,     // all, to CertifiedContactOptions::full_settling_tolerance
};

// Moves a scene from `before` to a pose in steps. An intersection-free start
// yields an intersection-free result unless the shortest step still leaves
// crossing triangles. Such a step is accepted all the same, as later steps may
// separate the triangles; the certificate reports any that remain.
CertifiedMotion MoveCertified(const PreparedScene& scene,
                              const CertifiedScene& certified,
                              const ScenePose& pose,
                              const PreRotationOptions& pre_rotation,
                              const MuscleSolver& solver,
                              const ContactState& before,
                              Settling settling,
                              const ProgressCallback& on_progress);

// Returns the coarse and fine vertices of a state, in the order of the scene.
MuscleShapes ShapesOf(const CertifiedScene& certified,
                      const ContactState& state);

// The same, of a scene that is not prepared for certified contact any more.
MuscleShapes ShapesOf(const PreparedScene& scene, const ContactState& state);

// Returns the coarse vertices of a state and the fine ones that they
// interpolate, without the offsets by contact, in the order of the scene.
MuscleShapes InterpolatedShapesOf(const CertifiedScene& certified,
                                  const ContactState& state);

// Returns the coarse vertices of the solve without contact, in the order of the
// scene, N x 3 each, mm.
std::vector<Points> FreeCoarseOf(const CertifiedScene& certified,
                                 const ContactState& state);

// Returns the contact rows of the coarse solve of each muscle and the owners of
// their planes, in the order of the scene.
std::vector<ContactRows> ContactRowsOf(const CertifiedScene& certified,
                                       const ContactState& state);

}  // namespace musclewarp
