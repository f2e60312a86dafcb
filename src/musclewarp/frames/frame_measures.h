// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/frames/muscle_shapes.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// What is measured only if somebody wants it.
struct MeasureOptions {
  bool vertex_gaps = true;  // MuscleFrame::gaps
};

// Returns the frame of muscles that a solver has moved to a pose: their points,
// volumes, folded triangles, lines and fibres, and everything that crosses. The
// times, `pose_steps`, moment arms and what concerns contact are left to the
// caller.
// `before` are the fine meshes that the pose was reached from, by muscle, n x
// 3, mm, or none if it was reached on its own. `meshes` are those of the scene
// and are moved to the pose.
Frame MeasureFrame(const PreparedScene& scene,
                   const ScenePose& pose,
                   const MuscleShapes& shapes,
                   const std::vector<Points>& before,
                   std::vector<SolverSummary> summaries,
                   SceneMeshes* meshes,
                   const MeasureOptions& options = {});

// Returns what certificate/shortcomings.h judges of a muscle.
JudgedMuscle JudgedMuscleOf(const PreparedMuscle& muscle,
                            const MuscleFigures& figures);

// Returns the frame of a scene with every mesh where it was delivered.
Frame RestFrame(const PreparedScene& scene,
                SceneMeshes* meshes,
                const MeasureOptions& options = {});

// Counts what crosses with every mesh where it was delivered.
SceneIntersections IntersectAsPrepared(const PreparedScene& scene,
                                       SceneMeshes* meshes);

// Counts what crosses with the fine vertices of muscles at `muscles` (n x 3
// each, mm) and bones in the rest pose.
SceneIntersections IntersectAtRest(const PreparedScene& scene,
                                   const std::vector<Points>& muscles,
                                   SceneMeshes* meshes);

}  // namespace musclewarp
