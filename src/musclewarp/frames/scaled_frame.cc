// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/scaled_frame.h"

#include "musclewarp/certificate/scaled_intersections.h"
#include "musclewarp/scene/scaled_scene.h"

namespace musclewarp {
namespace {

void ScaleLengths(double factor, SolverSummary* solver) {
  if (solver->stop_reason == StopReason::kNotRun) return;  // impossible values
  solver->initial_energy *= factor * factor;
  solver->final_energy *= factor * factor;
  solver->max_step *= factor;
  for (SolverIteration& iteration : solver->history) {
    iteration.max_step *= factor;
  }
}

void ScaleLengths(double factor, StretchMeasures* stretch) {
  stretch->largest_place *= factor;
  stretch->area_beyond_anatomy *= factor * factor;
  stretch->area_of_patches *= factor * factor;
  stretch->largest_patch *= factor * factor;
  stretch->patch_place *= factor;
}

void ScaleLengths(double factor, ShapeMeasures* shape) {
  shape->stretch_place *= factor;
  ScaleLengths(factor, &shape->triangles);
  shape->bend_place *= factor;
  shape->max_change *= factor;
  shape->change_place *= factor;
}

void ScaleLengths(double factor, AttachmentDrift* drift) {
  drift->mean *= factor;
  drift->max *= factor;
  drift->place *= factor;
}

void ScaleLengths(double factor,
                  std::map<std::string, std::vector<double>>* arms) {
  for (auto& [coordinate, values] : *arms) {
    for (double& arm : values) arm *= factor;
  }
}

void ScaleLengths(double factor, MuscleFrame* muscle) {
  muscle->points *= factor;
  ScaleLengths(factor, &muscle->solver);
  muscle->max_displacement *= factor;
  muscle->min_gap *= factor;
  muscle->gaps *= factor;
  muscle->max_contact_displacement *= factor;
  muscle->mean_contact_displacement *= factor;
  muscle->depth_without_contact *= factor;
  muscle->torn_patch.area *= factor * factor;
  muscle->torn_patch.place *= factor;
  muscle->push_depth *= factor;
  for (AttachmentDrift& drift : muscle->attachments) {
    ScaleLengths(factor, &drift);
  }
  ScaleLengths(factor, &muscle->shape);
  for (Points& line : muscle->lines) line *= factor;
  for (Points& fibre : muscle->fibres) fibre *= factor;
  for (double& length : muscle->path_lengths) length *= factor;
  ScaleLengths(factor, &muscle->line_moment_arms);
  ScaleLengths(factor, &muscle->fibre_moment_arms);
}

}  // namespace

void ScaleLengths(double factor, Frame* frame) {
  for (MuscleFrame& muscle : frame->muscles) ScaleLengths(factor, &muscle);
  for (Points& bone : frame->bones) bone *= factor;
  for (Eigen::Matrix4d& motion : frame->bones_from_rest) {
    ScaleTranslation(factor, &motion);
  }
  for (auto& [line, arms] : frame->path_moment_arms) {
    for (auto& [coordinate, arm] : arms) arm *= factor;
  }
  ScaleLengths(factor, &frame->intersections);
  for (DeliveredCrossing& crossing : frame->delivered_crossings) {
    ScaleLengths(factor, &crossing);
  }
  for (BoneOverlap& overlap : frame->bone_overlaps) {
    ScaleLengths(factor, &overlap);
  }
}

}  // namespace musclewarp
