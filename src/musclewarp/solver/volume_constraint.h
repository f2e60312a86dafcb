// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// The volume of the fine mesh as a function of the coarse vertices,
// g(X) = V(W X) - V_hat (paper eq. 2.6, 2.7, 2.9). With `corrections`, the fine
// mesh is W X + offset, and held vertices stay where they are held whatever X
// is, so that their rows of the gradient are zero.
struct FineVolume {
  double error = 0;  // g, mm^3
  Points gradient;   // J_g^T pulled back through W, N x 3, mm^2
};

FineVolume EvaluateFineVolume(const MuscleModel& model,
                              const Points& coarse,
                              const VertexCorrections& corrections = {});

// g alone, at half the cost.
double FineVolumeError(const MuscleModel& model,
                       const Points& coarse,
                       const VertexCorrections& corrections = {});

// What the paper uses far from the solution: the error of the coarse mesh,
// scaled to the fine one, but the gradient of the coarse mesh as it is.
FineVolume EvaluateCoarseVolume(const MuscleModel& model,
                                const Points& coarse,
                                const VertexCorrections& corrections = {});

// Fills in the final energy and the volume ratio.
void SummarizeSolution(const MuscleModel& model,
                       const MuscleTarget& target,
                       const MuscleState& state,
                       SolverSummary* summary);

}  // namespace musclewarp
