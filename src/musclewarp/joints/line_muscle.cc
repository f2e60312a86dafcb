// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/line_muscle.h"

#include <glog/logging.h>

#include <cmath>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {

MuscleEstimate EstimateMuscle(const LineMuscle& muscle) {
  const double length = PolylineLength(muscle.line.rest);
  CHECK_GT(length, 0) << muscle.line.name;
  CHECK_GT(muscle.volume, 0) << muscle.line.name;
  MuscleEstimate estimate;
  estimate.optimal_fibre_length = kFibreShare * length;
  estimate.max_isometric_force =
      kSpecificTension * muscle.volume / estimate.optimal_fibre_length;
  estimate.tendon_slack_length =
      length - estimate.optimal_fibre_length * std::cos(estimate.pennation);
  return estimate;
}

}  // namespace musclewarp
