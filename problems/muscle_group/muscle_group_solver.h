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
  // The formulation, the penalties and ceres::Solver::Options. The numbers of
  // rounds and iterations and the tolerances in it are not used: progress is
  // judged by `iteration`.
  SingleMuscleOptions muscle;

  // Step lengths and convergence of the group, as for the reference solver.
  GroupIterationOptions iteration;

  // Returns false and names the field, its value and the rule if a field of
  // either struct is out of range.
  bool IsValid(std::string* error) const;
};

// Deforms several muscles in contact with Ceres (paper section 3). It does what
// SolveGaussNewtonGroup does, with the same contact and the same rules of
// progress, but takes its steps from ceres::Solve on one problem of all muscles
// (MuscleGroupProblem). Each call of ceres::Solve gives one step and starts
// from the state that contact left (ContactCallback), with the trust region
// radius, the penalties and the multipliers of the call before.
//
// `states` are the start on entry and the result on return; `summaries`
// receives one summary per muscle. The result does not depend on the number of
// threads. Nothing is thrown: a step that Ceres cannot compute ends the solve
// as failed.
// Preconditions (CHECKed): the options are valid; there are as many models,
// targets and states, and at least one. `contact` has the same muscles.
void SolveMuscleGroup(const std::vector<const MuscleModel*>& models,
                      const std::vector<MuscleTarget>& targets,
                      const MuscleGroupOptions& options,
                      GroupContact* contact,
                      std::vector<MuscleState>* states,
                      std::vector<SolverSummary>* summaries);

}  // namespace musclewarp
