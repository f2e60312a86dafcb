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

// Moves the coarse vertices of one muscle (N x 3; start and result) to a
// target.
using MuscleSolver = std::function<void(const MuscleModel& model,
                                        const MuscleTarget& target,
                                        Points* coarse,
                                        SolverSummary* summary)>;

// Moves the muscles of a scene to their targets; states are start and result,
// a summary a muscle. `contact` is null if muscles deform on their own.
using GroupSolver =
    std::function<void(const std::vector<const MuscleModel*>& models,
                       const std::vector<MuscleTarget>& targets,
                       GroupContact* contact,
                       std::vector<MuscleState>* states,
                       std::vector<SolverSummary>* summaries)>;

// Solves every muscle on its own, spread over the threads of OpenMP; the result
// does not depend on their number. Not for contact (CHECKed).
GroupSolver EachOnItsOwn(MuscleSolver solver);

}  // namespace musclewarp
