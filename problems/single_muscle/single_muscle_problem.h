// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/problem.h>

#include "musclewarp/solver/hard_constraint_solver.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/volume_evaluator.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// Adds the terms of one muscle to `problem`, in the formulation of `unknowns`.
//
// In plain coordinates: a LaplacianTerm per coarse vertex, a CoordinatesTerm
// per skeleton and attachment row, a VolumeTerm. The readable formulation,
// against which the whitened one is tested; its skeleton and volume rows touch
// every block, which makes its normal matrix dense.
//
// In whitened unknowns the same energy is a WhitenedLinearTerm per unknown and
// a VolumeTerm. In both, a OneSidedTerm if the target has contact rows.
//
// `volume` is that of the model. All arguments must outlive the problem.
void AddMuscle(const MuscleModel& model,
               const MuscleTarget& target,
               const HardConstraint& constraint,
               VolumeEvaluator* volume,
               MuscleUnknowns* unknowns,
               ceres::Problem* problem);

}  // namespace musclewarp
