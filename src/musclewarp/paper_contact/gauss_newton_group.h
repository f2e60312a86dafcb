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

// The reference solver for several muscles in contact, paper section 3: the
// steps of gauss_newton_step.h for all of them, then contact, again and again,
// then the final check of the contact. `states` are the start and the result;
// the start should be near the end (the unconstrained minimisers), as vertices
// come out of an obstacle the way they went in. A summary a muscle.
// Preconditions (CHECKed): the options are valid, one state, target and model a
// muscle.
void SolveGaussNewtonGroup(const std::vector<const MuscleModel*>& models,
                           const std::vector<MuscleTarget>& targets,
                           const GroupIterationOptions& options,
                           GroupContact* contact,
                           std::vector<MuscleState>* states,
                           std::vector<SolverSummary>* summaries);

}  // namespace musclewarp
