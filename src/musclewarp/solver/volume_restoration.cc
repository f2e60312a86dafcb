// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_restoration.h"

#include <cmath>

#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/solver/volume_evaluator.h"

namespace musclewarp {
namespace {

// A step of Newton's method squares the error, so that five are enough for any
// error that is small.
constexpr int kMaxSteps = 5;
constexpr double kVolumeTolerance = 1e-10;  // relative

// Sets the offsets of held fine vertices such that W X + offset is where they
// are held.
void PinHeldVertices(const MuscleModel& model, MuscleState* state) {
  const HeldVertices& held = state->corrections.held_fine;
  if (held.IsEmpty()) return;
  const Points followed = Product(model.fine_from_coarse, state->coarse);
  Points& offset = state->corrections.fine_offset;
  if (offset.rows() == 0) offset.setZero(followed.rows(), 3);
  for (size_t k = 0; k < held.vertices.size(); ++k) {
    const int v = held.vertices[k];
    offset.row(v) = held.positions.row(k) - followed.row(v);
  }
}

}  // namespace

double RestoreVolume(const MuscleModel& model, MuscleState* state) {
  VolumeEvaluator volume(model, &state->corrections);
  double relative_error = INFINITY;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double error = volume.Error(state->coarse);
    relative_error = error / model.rest_volume;
    if (std::abs(relative_error) < kVolumeTolerance) break;
    const Points& gradient = volume.Gradient(state->coarse);
    const Points direction = model.normal_matrix.solve(gradient);
    const double slope = gradient.cwiseProduct(direction).sum();
    if (!(slope > 0)) break;
    state->coarse -= error / slope * direction;
  }
  PinHeldVertices(model, state);
  return relative_error;
}

}  // namespace musclewarp
