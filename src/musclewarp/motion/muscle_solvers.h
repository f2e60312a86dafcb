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
// contact between them. `states` are the start and the result; `summaries` gets
// one entry per muscle.
using GroupSolver =
    std::function<void(const std::vector<const MuscleModel*>& models,
                       const std::vector<MuscleTarget>& targets,
                       GroupContact* contact,
                       std::vector<MuscleState>* states,
                       std::vector<SolverSummary>* summaries)>;

// The solvers that move the muscles of a scene. They make motion/ independent
// of the implementation: Ceres or the reference.
struct MuscleSolvers {
  MuscleSolver single;
  GroupSolver group;
};

// Puts a muscle back to where it was before a solve that came to coordinates
// which are not finite, or to rest if its start was not finite either, and says
// so in the summary, whose stop reason is then kFailed. Every result of a
// solver passes through here: boxes and predicates of what is not finite would
// be silent.
void KeepFinite(const MuscleModel& model,
                const MuscleState& before,
                MuscleState* state,
                SolverSummary* summary);

// Solves every muscle on its own, in parallel by OpenMP. The result does not
// depend on the number of threads. A muscle without lines keeps its state and
// counts as converged. What is not finite is thrown away (KeepFinite).
void SolveEachOnItsOwn(const MuscleSolver& solver,
                       const std::vector<const MuscleModel*>& models,
                       const std::vector<MuscleTarget>& targets,
                       std::vector<MuscleState>* states,
                       std::vector<SolverSummary>* summaries);

}  // namespace musclewarp
