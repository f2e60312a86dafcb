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
// The cost is then the linear energy of paper eq. (2.8), in the whitened
// formulation without its constant, plus the augmented Lagrangian of the
// volume.
//
// - In coarse vertices: a LaplacianTerm per vertex and a CoordinatesTerm per
//   skeleton and attachment row. This is the readable formulation, against
//   which the whitened one is tested. Its skeleton and volume rows touch every
//   block, which makes the normal matrix dense.
// - In whitened unknowns: a WhitenedLinearTerm per unknown.
// - In both: a OneSidedTerm if the target has one-sided rows, then a
// VolumeTerm.
//
// `volume` evaluates the volume of the same model. The problem owns the terms;
// all arguments must outlive it.
void AddMuscle(const MuscleModel& model,
               const MuscleTarget& target,
               const HardConstraint& constraint,
               VolumeEvaluator* volume,
               MuscleUnknowns* unknowns,
               ceres::Problem* problem);

}  // namespace musclewarp
