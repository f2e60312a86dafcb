// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/contact/scene_intersections.h"
#include "musclewarp/motion/group_solver.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/scene_contact.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// A muscle in one pose.
struct MuscleFrame {
  Points fine;  // n x 3, mm
  SolverSummary solver;
  double volume_ratio = 0;  // of the fine mesh to its rest volume
  int folded_triangles = 0;
  double max_displacement = 0;                 // of a fine vertex from rest, mm
  std::map<std::string, double> line_lengths;  // target polylines, mm
};

// The whole scene in one pose. Muscles and bones in scene order.
struct Frame {
  int index = 0;
  const ScenePose* pose = nullptr;
  std::vector<MuscleFrame> muscles;
  std::vector<Points> bones;  // #V x 3, mm
  SceneIntersections intersections;
  double wall_ms = 0;     // moving the scene to the pose
  double solve_ms = 0;    // of that, in the solver
  double certify_ms = 0;  // counting intersections and folded triangles

  int iterations() const;  // of all muscles
  // "converged", or the reason and the muscle that did not.
  std::string stop_reason(const PreparedScene& scene) const;
  bool IsUsable() const;
};

// Deforms the muscles from their rest pose, on their own; or with `contact`
// (null: without) together, from the shape they have without contact and volume
// constraint: bones do not pass through their rest pose on the way.
Frame SolveFrame(const PreparedScene& scene,
                 const SceneContact* contact,
                 int index,
                 const PreRotationOptions& pre_rotation,
                 const GroupSolver& solver);

// The same scene with every mesh where it came.
SceneIntersections RestIntersections(const PreparedScene& scene);

// And after the initial fix of its contact.
SceneIntersections RestIntersectionsAfterFix(const PreparedScene& scene,
                                             const SceneContact& contact);

}  // namespace musclewarp
