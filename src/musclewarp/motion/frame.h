// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/motion/group_solver.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/scene_contact.h"
#include "musclewarp/motion/scene_meshes.h"
#include "musclewarp/motion/solved_pose.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// Gaps to other meshes are looked for up to this distance, mm.
constexpr double kGapLimit = 5;

// A muscle in one pose.
struct MuscleFrame {
  Points fine;  // n x 3, mm
  SolverSummary solver;
  double volume_ratio = 0;  // of the fine mesh to its rest volume
  int folded_triangles = 0;
  double max_displacement = 0;  // of a fine vertex from rest, mm
  // n: to the nearest other mesh, mm, negative inside one; at most kGapLimit.
  Eigen::VectorXd gaps;
  int self_pairs = 0;  // of triangles that cross each other
  // With certified contact: how far contact moved a fine vertex, and how deep
  // the deepest vertex is in another mesh, or of another in this one, without
  // contact, mm.
  double max_contact_displacement = 0;
  double mean_contact_displacement = 0;
  double depth_without_contact = 0;
  // The action lines, sampled, and the fibres, as the muscle carries them.
  std::vector<Points> lines;
  std::vector<Points> fibres;
  // Of each action line straight through its path points, mm.
  std::vector<double> path_lengths;
};

// The whole scene in one pose. Muscles and bones in scene order.
struct Frame {
  int index = 0;                    // of the pose, -1 at rest
  const ScenePose* pose = nullptr;  // null at rest
  std::vector<MuscleFrame> muscles;
  std::vector<Points> bones;  // #V x 3, mm
  // Of the straight lines, by line and coordinate, mm/rad (or mm/m).
  std::map<std::string, std::map<std::string, double>> path_moment_arms;
  SceneIntersections intersections;
  int pose_steps = 1;  // solves on the way from the frame before
  // What a certified frame must hold and this one does not; see Shortcomings().
  std::vector<std::string> shortcomings;
  double wall_ms = 0;     // moving the scene to the pose
  double solve_ms = 0;    // of that, in the solver
  double certify_ms = 0;  // counting intersections and folded triangles

  int iterations() const;  // of all muscles
  // "converged", or the reason and the muscle that did not.
  std::string stop_reason(const PreparedScene& scene) const;
  bool IsUsable() const;
};

struct FrameOptions {
  PreRotationOptions pre_rotation;

  // With contact a frame of a motion is reached in steps in which no body turns
  // and no point of a line moves by more than this, so that no bone passes
  // through a muscle between two of them.
  double max_turn = 5 * M_PI / 180;  // rad
  double max_move = 10;              // mm

  bool IsValid(std::string* error) const;
};

// Steps from one pose to another by those limits; at least 1.
int StepsBetween(const Scene& scene,
                 const ScenePose& from,
                 const ScenePose& to,
                 const FrameOptions& options);

// Moves the muscles to pose `index`. Without `state` they start from rest, on
// their own; or with `contact` (null: without) together, from the shape they
// have without contact and volume constraint: bones do not pass through their
// rest pose on the way. With `state`, that of the frame before (or StartState),
// they start from there, moved on as the unconstrained shapes move, and `state`
// becomes that of this frame. `meshes` are those of the scene, for counting.
// Precondition (CHECKed): the options are valid.
Frame SolveFrame(const PreparedScene& scene,
                 const SceneContact* contact,
                 int index,
                 const FrameOptions& options,
                 const GroupSolver& solver,
                 SceneMeshes* meshes,
                 SceneState* state = nullptr);

// Where the first frame of a motion starts: at rest, with contact after a solve
// of the rest pose, which parts what overlaps as the data come.
SceneState StartState(const PreparedScene& scene,
                      const SceneContact* contact,
                      const FrameOptions& options,
                      const GroupSolver& solver);

// Fills in everything of a frame but the times and `pose_steps`, which are of
// the way there.
void MeasureFrame(const PreparedScene& scene,
                  const ScenePose& pose,
                  const std::vector<MuscleState>& states,
                  std::vector<SolverSummary> summaries,
                  SceneMeshes* meshes,
                  Frame* frame);

// The bones of a scene in a pose, #V x 3, mm.
std::vector<Points> BonesIn(const PreparedScene& scene, const ScenePose& pose);

// The scene with every mesh where it came.
Frame RestFrame(const PreparedScene& scene, SceneMeshes* meshes);

// What crosses after the initial fix of its contact.
SceneIntersections RestIntersectionsAfterFix(const PreparedScene& scene,
                                             const SceneContact& contact,
                                             SceneMeshes* meshes);

}  // namespace musclewarp
