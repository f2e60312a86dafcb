// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/problem.h>

#include "musclewarp/solver/hard_constraint_solver.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "problems/single_muscle/whitening.h"

namespace musclewarp {

// Adds the terms of one muscle in plain coordinates to `problem`: a
// LaplacianTerm per coarse vertex, a CoordinatesTerm per skeleton and
// attachment row, a VolumeTerm. The parameter blocks are the rows of `coarse`
// (N x 3). The readable formulation, against which the whitened one is tested;
// its skeleton and volume rows touch every block, which makes its normal matrix
// dense.
//
// All arguments but the target must outlive the problem.
void AddMuscleInBlocks(const MuscleModel& model,
                       const MuscleTarget& target,
                       const HardConstraint& constraint,
                       Points* coarse,
                       ceres::Problem* problem);

// Adds the same energy in whitened unknowns: a WhitenedLinearTerm per unknown
// and a VolumeTerm. The parameter blocks are the rows of `whitened` (N x 3).
void AddMuscleWhitened(const MuscleModel& model,
                       const Whitening& whitening,
                       const HardConstraint& constraint,
                       Points* whitened,
                       ceres::Problem* problem);

}  // namespace musclewarp
