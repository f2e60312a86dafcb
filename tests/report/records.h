// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// Records with a value of their own in every field.
inline MuscleRecord SomeMuscleRecord(int index) {
  MuscleRecord muscle;
  muscle.name = "m";
  muscle.volume_mm3 = 2e5 / 7;
  muscle.volume_ratio = 1 - 1e-16;
  muscle.max_step_mm = 0.1;
  muscle.max_displacement_mm = 12;
  muscle.min_gap_mm = -0.5;
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
  muscle.iterations = 17;
  muscle.solve_ms = 0.6;
  muscle.initial_energy_mm2 = 5;
  muscle.final_energy_mm2 = 4;
  muscle.stop_reason = "converged";
  muscle.line_lengths_mm = {{"l", 100 + index * index}};
  muscle.path_lengths_mm = {{"l", 101}};
  muscle.fibre_lengths_mm = {50.0 + index, 60};
  muscle.line_moment_arms_mm = {{"l", {{"hip", 20.0 / 3}, {"knee", 0}}}};
  muscle.fibre_moment_arms_mm = {{"hip", {1.0 / 7, -2}}};
  return muscle;
}

inline FrameRecord SomeRecord(int index) {
  FrameRecord record;
  record.index = index;
  record.name = "t=0.1 \"quoted\"";
  record.time = 0.1 + index;
  record.coordinates = {{"hip", 1.0 / 3}, {"knee", -2}};
  record.wall_ms = 1.5;
  record.solve_ms = 0.7;
  record.certify_ms = 3e-300;
  record.moment_arms_ms = 0.4;
  record.stages = {{"relaxation", 2e-3, 3}, {"moment arms", 0.4, 1}};
  record.moment_arms_converged = false;
  record.pose_steps = 4;
  record.iterations = 17;
  record.stop_reason = "converged";
  record.usable = true;
  record.bone_overlaps = {{"pelvis", "femur", 3.7 / 3, {1, 2.0 / 3, -4}}};
  record.muscles = {SomeMuscleRecord(index)};
  record.path_moment_arms_mm = {{"l", {{"hip", 25}, {"knee", -3}}}};
  record.intersections.triangle_pairs = 9;
  record.intersections.vertices_inside = 2;
  record.intersections.max_depth_mm = 0.3;
  record.intersections.self_pairs = 1;
  record.intersections.exempt_pairs = 4;
  PairIntersection pair;
  pair.a = "m";
  pair.b = "b";
  pair.triangle_pairs = 9;
  pair.vertices_inside = 2;
  pair.max_depth_mm = 0.3;
  pair.exempt_pairs = 4;
  record.intersections.pairs = {pair};
  record.intersections.gaps = {{"m", "b", 0, 0, {1, 2, 3}},
                               {"m", "c", 1.0 / 3, 0.4, {0.1, -2e-9, 7}}};
  return record;
}

}  // namespace musclewarp
