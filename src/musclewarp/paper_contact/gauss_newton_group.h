// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/paper_contact/group_progress.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// Deforms several muscles in contact with the paper's own solver (section 3),
// the reference for the Ceres formulation (SolveMuscleGroup). Each iteration
// takes a step of gauss_newton_step.h for every muscle and then lets `contact`
// roll back what the step carried into other bodies. After the last iteration
// contact makes its final check and the volumes are made exact.
//
// `states` are the start on entry and the result on return. The start should be
// near the result, for example the unconstrained minimisers, since a vertex
// leaves an obstacle on the side where it went in. `summaries` receives one
// summary per muscle; they have the stop reason in common. Muscles are computed
// in parallel, and the result does not depend on the number of threads.
//
// One-sided rows of the targets are not supported and ignored.
// Preconditions (CHECKed): the options are valid; there are as many models,
// targets and states, and at least one. `contact` has the same muscles.
void SolveGaussNewtonGroup(const std::vector<const MuscleModel*>& models,
                           const std::vector<MuscleTarget>& targets,
                           const GroupIterationOptions& options,
                           GroupContact* contact,
                           std::vector<MuscleState>* states,
                           std::vector<SolverSummary>* summaries);

}  // namespace musclewarp
