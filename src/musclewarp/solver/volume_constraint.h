// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// The volume constraint at one place: the volume error of the fine mesh as a
// function of the coarse vertices, g(X) = V(W X) - V_hat, and its derivative
// (paper eq. 2.6, 2.7, 2.9).
//
// With `corrections` (below) the fine mesh is W X + offset, and held vertices
// stay where they are held whatever X is, so that their rows of the gradient
// are zero.
struct FineVolume {
  double error = 0;  // g, mm^3
  Points gradient;   // J_g^T, pulled back through W, N x 3, mm^2
};

// Evaluates the error and the gradient at `coarse` (N x 3, mm). The cost is
// that of two passes over the dense matrix W.
FineVolume EvaluateFineVolume(const MuscleModel& model,
                              const Points& coarse,
                              const VertexCorrections& corrections = {});

// Returns the error g alone, mm^3, at half the cost.
double FineVolumeError(const MuscleModel& model,
                       const Points& coarse,
                       const VertexCorrections& corrections = {});

// Evaluates the substitute that the paper uses far from the solution, at next
// to no cost: the error is that of the coarse mesh scaled by the ratio of the
// rest volumes, mm^3, but the gradient is that of the coarse mesh as it is, as
// in the paper.
FineVolume EvaluateCoarseVolume(const MuscleModel& model,
                                const Points& coarse,
                                const VertexCorrections& corrections = {});

// Fills in the fields of a summary that every solver computes in the same way:
// the final energy and the volume ratio of the fine mesh.
void SummarizeSolution(const MuscleModel& model,
                       const MuscleTarget& target,
                       const MuscleState& state,
                       SolverSummary* summary);

}  // namespace musclewarp
