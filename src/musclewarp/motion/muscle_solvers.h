// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// Moves the coarse vertices of one muscle (N x 3, mm; the start and the result)
// to a target.
using MuscleSolver = std::function<void(const MuscleModel& model,
                                        const MuscleTarget& target,
                                        Points* coarse,
                                        SolverSummary* summary)>;

// Moves all muscles of a scene to their targets together, with the paper's
// contact between them. The states are the start and the result; there is a
// summary for each muscle.
using GroupSolver =
    std::function<void(const std::vector<const MuscleModel*>& models,
                       const std::vector<MuscleTarget>& targets,
                       GroupContact* contact,
                       std::vector<MuscleState>* states,
                       std::vector<SolverSummary>* summaries)>;

// The solvers that move the muscles of a scene. The code of motion/ does not
// know whether they are those of Ceres or the reference.
struct MuscleSolvers {
  MuscleSolver single;
  GroupSolver group;
};

// Solves every muscle on its own, spread over the threads of OpenMP. The result
// does not depend on their number. A muscle without lines stays as it is, which
// counts as converged.
void SolveEachOnItsOwn(const MuscleSolver& solver,
                       const std::vector<const MuscleModel*>& models,
                       const std::vector<MuscleTarget>& targets,
                       std::vector<MuscleState>* states,
                       std::vector<SolverSummary>* summaries);

}  // namespace musclewarp
