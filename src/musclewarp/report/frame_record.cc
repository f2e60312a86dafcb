// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/frame_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "musclewarp/frames/fibre_measures.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

MuscleRecord RecordOf(const PreparedMuscle& muscle, const MuscleFrame& frame) {
  const MuscleModel& model = muscle.model;
  MuscleRecord record;
  record.name = model.name;
  record.volume_mm3 = frame.volume_ratio * muscle.mesh.delivered_volume;
  record.volume_ratio = frame.volume_ratio;
  record.volume_error = frame.volume_error;
  record.max_step_mm = frame.solver.max_step;
  record.max_displacement_mm = frame.max_displacement;
  record.min_gap_mm = frame.min_gap;
  record.folded_triangles = frame.folded_triangles;
  record.self_pairs = frame.self_pairs;
  record.max_contact_displacement_mm = frame.max_contact_displacement;
  record.mean_contact_displacement_mm = frame.mean_contact_displacement;
  record.depth_without_contact_mm = frame.depth_without_contact;
  record.torn_patch = frame.torn_patch;
  record.push_depth_mm = frame.push_depth;
  record.pushed_by = frame.pushed_by;
  record.attachments = frame.attachments;
  record.shape = frame.shape;
  record.iterations = frame.solver.iterations;
  record.solve_ms = frame.solver.wall_ms;
  record.initial_energy_mm2 = frame.solver.initial_energy;
  record.final_energy_mm2 = frame.solver.final_energy;
  record.stop_reason = ToString(frame.solver.stop_reason);
  for (size_t i = 0; i < model.lines.size(); ++i) {
    const std::string& name = model.lines[i].name;
    record.line_lengths_mm[name] = PolylineLength(frame.lines[i]);
    record.path_lengths_mm[name] = frame.path_lengths[i];
    for (const auto& [coordinate, arms] : frame.line_moment_arms) {
      record.line_moment_arms_mm[name][coordinate] = arms[i];
    }
  }
  for (const Points& fibre : frame.fibres) {
    record.fibre_lengths_mm.push_back(PolylineLength(fibre));
  }
  if (!frame.fibres.empty()) {
    const std::array<double, 5> fifths = StretchByFifths(
        LinesAt(muscle.fibres, model.coarse_rest), frame.fibres);
    record.fibre_stretch_by_fifths.assign(fifths.begin(), fifths.end());
  }
  for (const auto& [coordinate, arms] : frame.fibre_moment_arms) {
    if (std::all_of(
            arms.begin(), arms.end(), [](double arm) { return arm == 0; })) {
      continue;
    }
    record.fibre_moment_arms_mm[coordinate] = arms;
  }
  return record;
}

}  // namespace

double FrameRecord::WorstVolumeError() const {
  double worst = 0;
  for (const MuscleRecord& muscle : muscles) {
    worst = std::max(worst, std::abs(muscle.volume_error));
  }
  return worst;
}

int FrameRecord::FoldedTriangles() const {
  int sum = 0;
  for (const MuscleRecord& muscle : muscles) sum += muscle.folded_triangles;
  return sum;
}

FrameRecord RecordOf(const PreparedScene& scene, const Frame& frame) {
  FrameRecord record;
  record.index = frame.index;
  record.name = frame.name;
  record.time = frame.time;
  record.coordinates = frame.coordinates;
  record.wall_ms = frame.wall_ms;
  record.solve_ms = frame.solve_ms;
  record.certify_ms = frame.certify_ms;
  record.moment_arms_ms = frame.moment_arms_ms;
  record.stages = frame.stages;
  record.pose_steps = frame.pose_steps;
  record.iterations = frame.iterations();
  record.stop_reason = frame.stop_reason();
  record.usable = frame.IsUsable();
  record.shortcomings = frame.shortcomings;
  record.bone_overlaps = frame.bone_overlaps;
  record.delivered_crossings = frame.delivered_crossings;
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    record.muscles.push_back(RecordOf(scene.muscles[i], frame.muscles[i]));
  }
  record.path_moment_arms_mm = frame.path_moment_arms;
  record.moment_arms_converged = frame.moment_arms_converged;
  record.intersections = frame.intersections;
  record.intersections.DropLists();
  return record;
}

}  // namespace musclewarp
