// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/contact/scene_intersections.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// Moves the coarse vertices of one muscle (N x 3; start and result) to a
// target.
using MuscleSolver = std::function<void(const MuscleModel& model,
                                        const MuscleTarget& target,
                                        Points* coarse,
                                        SolverSummary* summary)>;

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
  double wall_ms = 0;     // solving
  double certify_ms = 0;  // counting intersections and folded triangles

  int iterations() const;  // of all muscles
  // "converged", or the reason and the muscle that did not.
  std::string stop_reason(const PreparedScene& scene) const;
  bool IsUsable() const;
};

// Deforms every muscle on its own, from its rest pose; muscles are spread over
// the threads of OpenMP, and the result does not depend on their number.
Frame SolveFrame(const PreparedScene& scene,
                 int index,
                 const PreRotationOptions& pre_rotation,
                 const MuscleSolver& solver);

// The same scene with every mesh where it came.
SceneIntersections RestIntersections(const PreparedScene& scene);

}  // namespace musclewarp
