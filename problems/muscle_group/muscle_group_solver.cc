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

// Largest number of trial steps in one solve: Ceres rejects steps that do not
// reduce the cost.
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
        // Ceres has converged for these multipliers: a step of length zero.
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
      // The full step aims beyond zero, so that the shortened step corrects
      // max(alpha, min_volume_fraction) of the error.
      group_.constraints[i]->target =
          (1 - 1 / progress_.volume_alpha()) * error / models_[i]->rest_area;
    }
  }

  // Makes the initial fix, in the first solve. Returns true if it moved
  // anything.
  bool BeforeStep() {
    return !std::exchange(has_started_, true) && contact_.Start(&states_);
  }

  // Shortens the step and applies contact. On entry the parameter blocks hold
  // the end of the full step from the states.
  void AfterStep() {
    for (int i = 0; i < num_muscles_; ++i) {
      const Points full_step = group_.unknowns[i]->Coarse();
      UpdateConstraint(i, full_step);
      // The step is shortened before contact sees it, as in the paper: a vertex
      // goes back along its step, and a short step points to where it came in.
      Points& coarse = states_[i].coarse;
      coarse += progress_.alpha() * (full_step - coarse);
    }
    contact_.AfterStep(progress_.alpha(), &states_);
    progress_.Record(contact_, volume_errors_);
  }

  // Makes one round of the method of multipliers, with the violation after the
  // full step. What the shortened step leaves of the violation says nothing
  // about the multiplier.
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
