// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/muscle_group/muscle_group_solver.h"

#include <ceres/solver.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/muscle_group/contact_callback.h"
#include "problems/muscle_group/muscle_group_problem.h"

namespace musclewarp {
namespace {

// Of steps that Ceres takes back before one is taken.
constexpr int kMaxTrials = 10;

class MuscleGroupSolver {
 public:
  MuscleGroupSolver(const std::vector<const MuscleModel*>& models,
                    const std::vector<MuscleTarget>& targets,
                    const MuscleGroupOptions& options,
                    GroupContact* contact,
                    std::vector<MuscleState>* states,
                    GroupProgress* progress)
      : models_(models),
        num_muscles_(static_cast<int>(models.size())),
        options_(options),
        contact_(*contact),
        states_(*states),
        progress_(*progress),
        group_(models, targets, options.muscle.formulation, *states),
        volume_errors_(models.size(), 0),
        previous_violations_(models.size(), INFINITY) {
    for (auto& constraint : group_.constraints) {
      constraint->penalty = options.muscle.hard_constraint.initial_penalty;
    }
  }

  void Iterate() {
    ContactCallback callback([this] { return BeforeStep(); },
                             [this] { AfterStep(); });
    ceres::Solver::Options options = options_.muscle.hard_constraint.ceres;
    options.max_num_iterations = kMaxTrials;
    options.update_state_every_iteration = true;
    options.callbacks = {&callback};
    while (!progress_.IsOver()) {
      PrepareStep();
      ceres::Solver::Summary summary;
      ceres::Solve(options, &group_.problem, &summary);
      options.initial_trust_region_radius = callback.trust_region_radius();
      if (!summary.IsSolutionUsable()) {
        progress_.Fail(0, summary.message);
      } else if (!callback.TakeHasChanged()) {
        // Converged for these multipliers: a step of no length.
        AfterStep();
      }
    }
  }

 private:
  void PrepareStep() {
    group_.SetStates(states_);
    group_.SetVolumeMesh(progress_.is_fine_volume() ? VolumeMesh::kFine
                                                    : VolumeMesh::kCoarse);
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < num_muscles_; ++i) {
      const double error =
          group_.volumes[i]->Error(group_.unknowns[i]->Coarse());
      volume_errors_[i] = error / models_[i]->rest_volume;
      // So much beyond zero that the shortened step corrects enough.
      group_.constraints[i]->target =
          (1 - 1 / progress_.volume_alpha()) * error / models_[i]->rest_area;
    }
  }

  // The initial fix, once; true if it has moved something.
  bool BeforeStep() {
    return !std::exchange(has_started_, true) && contact_.Start(&states_);
  }

  // The parameter blocks hold the end of the full step from the states.
  void AfterStep() {
    for (int i = 0; i < num_muscles_; ++i) {
      const Points full_step = group_.unknowns[i]->Coarse();
      UpdateConstraint(i, full_step);
      // As the paper has it: a vertex goes back along its step, and a short one
      // shows the way out.
      Points& coarse = states_[i].coarse;
      coarse += progress_.alpha() * (full_step - coarse);
    }
    contact_.AfterStep(progress_.alpha(), &states_);
    progress_.Record(contact_, volume_errors_);
  }

  // One round of the method of multipliers, for the full step: what is left of
  // the violation after the shortened one is no fault of the multiplier.
  void UpdateConstraint(int i, const Points& full_step) {
    const HardConstraintOptions& options = options_.muscle.hard_constraint;
    HardConstraint& constraint = *group_.constraints[i];
    const double violation =
        group_.volumes[i]->Error(full_step) / models_[i]->rest_area -
        constraint.target;
    constraint.Update(
        options, violation, previous_violations_[i], /*is_minimum=*/true);
    previous_violations_[i] = violation;
  }

  const std::vector<const MuscleModel*>& models_;
  const int num_muscles_;
  const MuscleGroupOptions& options_;
  GroupContact& contact_;
  std::vector<MuscleState>& states_;
  GroupProgress& progress_;
  MuscleGroupProblem group_;
  bool has_started_ = false;
  std::vector<double> volume_errors_;  // relative, where the step starts
  std::vector<double> previous_violations_;
};

}  // namespace

bool MuscleGroupOptions::IsValid(std::string* error) const {
  return muscle.IsValid(error) && iteration.IsValid(error);
}

void SolveMuscleGroup(const std::vector<const MuscleModel*>& models,
                      const std::vector<MuscleTarget>& targets,
                      const MuscleGroupOptions& options,
                      GroupContact* contact,
                      std::vector<MuscleState>* states,
                      std::vector<SolverSummary>* summaries) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  GroupProgress progress(
      models, targets, *states, options.iteration, *contact, summaries);
  MuscleGroupSolver(models, targets, options, contact, states, &progress)
      .Iterate();
  contact->Finish(states);
  progress.Finish(*states);
}

}  // namespace musclewarp
