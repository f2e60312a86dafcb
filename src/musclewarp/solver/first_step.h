// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/volume_evaluator.h"

namespace musclewarp {

// What the first order tells of the constrained minimum from a place near it.
struct FirstStep {
  // The multiplier of the volume error (mm^-1) that balances the forces best,
  // in the norm of A^-1. At a minimum it is that of the minimum: a shape that
  // is carried from pose to pose brings it along.
  double multiplier = 0;
  double length = 0;  // of the largest move of a coarse vertex, mm
};

// Estimates the step from `coarse` (N x 3, mm) with the volume of `volume`.
FirstStep FirstStepFrom(const MuscleModel& model,
                        const MuscleTarget& target,
                        const Points& coarse,
                        VolumeEvaluator* volume);

}  // namespace musclewarp
