// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/paper_contact/group_progress.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"
#include "problems/single_muscle/single_muscle_solver.h"

namespace musclewarp {

struct MuscleGroupOptions {
  // Formulation, penalty and ceres::Solver::Options; its numbers of rounds and
  // iterations are not used.
  SingleMuscleOptions muscle;
  GroupIterationOptions iteration;

  bool IsValid(std::string* error) const;
};

// Deforms several muscles in contact with Ceres (paper section 3): what
// SolveGaussNewtonGroup does, by the same contact, with steps from ceres::Solve
// on one problem of all muscles (ContactCallback). Each solve starts from the
// state that contact left, with the trust region radius, the penalties and the
// multipliers of the one before.
// Precondition (CHECKed): the options are valid.
void SolveMuscleGroup(const std::vector<const MuscleModel*>& models,
                      const std::vector<MuscleTarget>& targets,
                      const MuscleGroupOptions& options,
                      GroupContact* contact,
                      std::vector<MuscleState>* states,
                      std::vector<SolverSummary>* summaries);

}  // namespace musclewarp
