// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/figures/frame_figures.h"

namespace musclewarp {

// Figures with a value of their own in every field.
inline MuscleFigures SomeMuscleFigures(int index) {
  MuscleFigures muscle;
  muscle.name = "m";
  muscle.volume = 2e5 / 7;
  muscle.volume_ratio = 1 - 1e-16;
  muscle.solver.max_step = 0.1;
  muscle.max_displacement = 12;
  muscle.min_gap = -0.5;
  muscle.folded_triangles = 3;
  muscle.attachments = {{"pelvis", 12, 0.1 / 3, 0.7, {1, 2, 1.0 / 3}}};
  muscle.shape.max_stretch = 1.2 / 7;
  muscle.shape.max_stretch_along = 1.1;
  muscle.shape.max_stretch_across = 1.05;
  muscle.shape.stretch_place << 1, -2, 1.0 / 7;
  muscle.shape.min_area_ratio = 0.9;
  muscle.shape.max_area_ratio = 1.3;
  muscle.shape.max_bend = 100.0 / 3;
  muscle.shape.bend_place << 4, 5, 6;
  muscle.shape.max_change = 0.7;
  muscle.shape.change_place << 7, 8, 9;
  muscle.shape.triangles.mean = 1.01;
  muscle.shape.triangles.quantile_99 = 1.1 / 7;
  muscle.shape.triangles.quantile_999 = 1.15;
  muscle.shape.triangles.largest = 2.3;
  muscle.shape.triangles.largest_place << 1, 2, 3.0 / 7;
  muscle.shape.triangles.area_beyond_anatomy = 12.5;
  muscle.shape.triangles.area_of_patches = 4.5;
  muscle.shape.triangles.largest_patch = 3.5;
  muscle.shape.triangles.patch_place << 3, 2, 1;
  muscle.solver.iterations = 17;
  muscle.solver.wall_ms = 0.6;
  muscle.solver.initial_energy = 5;
  muscle.solver.final_energy = 4;
  muscle.solver.stop_reason = StopReason::kConverged;
  muscle.line_lengths = {{"l", 100 + index * index}};
  muscle.path_lengths = {{"l", 101}};
  muscle.fibre_lengths = {50.0 + index, 60};
  muscle.line_moment_arms = {{"l", {{"hip", 20.0 / 3}, {"knee", 0}}}};
  muscle.fibre_moment_arms = {{"hip", {1.0 / 7, -2}}};
  return muscle;
}

inline FrameFigures SomeFigures(int index) {
  FrameFigures figures;
  figures.index = index;
  figures.name = "t=0.1 \"quoted\"";
  figures.time = 0.1 + index;
  figures.coordinates = {{"hip", 1.0 / 3}, {"knee", -2}};
  figures.wall_ms = 1.5;
  figures.solve_ms = 0.7;
  figures.certify_ms = 3e-300;
  figures.moment_arms_ms = 0.4;
  figures.stages = {{"relaxation", 2e-3, 3}, {"moment arms", 0.4, 1}};
  figures.moment_arms_converged = false;
  figures.pose_steps = 4;
  figures.bone_overlaps = {{"pelvis", "femur", 3.7 / 3, {1, 2.0 / 3, -4}}};
  figures.muscles = {SomeMuscleFigures(index)};
  figures.path_moment_arms = {{"l", {{"hip", 25}, {"knee", -3}}}};
  figures.intersections.triangle_pairs = 9;
  figures.intersections.vertices_inside = 2;
  figures.intersections.max_depth_mm = 0.3;
  figures.intersections.self_pairs = 1;
  figures.intersections.exempt_pairs = 4;
  PairFigures pair;
  pair.a = "m";
  pair.b = "b";
  pair.triangle_pairs = 9;
  pair.vertices_inside = 2;
  pair.max_depth_mm = 0.3;
  pair.exempt_pairs = 4;
  figures.intersections.pairs = {pair};
  figures.intersections.gaps = {{"m", "b", 0, 0, {1, 2, 3}},
                                {"m", "c", 1.0 / 3, 0.4, {0.1, -2e-9, 7}}};
  return figures;
}

}  // namespace musclewarp
