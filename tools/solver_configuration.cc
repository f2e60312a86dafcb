// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/solver_configuration.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/paper_contact/gauss_newton_group.h"

namespace musclewarp {
namespace {

MuscleSolver MuscleSolverOf(const SolverConfiguration& configuration) {
  if (configuration.is_reference) {
    return [&configuration](const MuscleModel& model,
                            const MuscleTarget& target,
                            Points* coarse,
                            SolverSummary* summary) {
      SolveGaussNewton(
          model, target, configuration.gauss_newton, coarse, summary);
    };
  }
  return [&configuration](const MuscleModel& model,
                          const MuscleTarget& target,
                          Points* coarse,
                          SolverSummary* summary) {
    SolveSingleMuscle(
        model, target, configuration.ceres.muscle, coarse, summary);
  };
}

}  // namespace

bool SolverConfiguration::IsValid(std::string* error) const {
  return gauss_newton.IsValid(error) && ceres.IsValid(error);
}

const std::vector<std::string>& SolverConfigurationNames() {
  static const std::vector<std::string> kNames = {"reference",
                                                  "ceres",
                                                  "ceres_dense_cholesky",
                                                  "ceres_sparse_cholesky",
                                                  "ceres_cgnr",
                                                  "ceres_dogleg"};
  return kNames;
}

SolverConfiguration SolverConfigurationNamed(const std::string& name) {
  const auto& names = SolverConfigurationNames();
  CHECK(std::count(names.begin(), names.end(), name)) << name;
  SolverConfiguration configuration;
  configuration.name = name;
  configuration.is_reference = name == "reference";
  if (name == "reference" || name == "ceres") return configuration;

  SingleMuscleOptions& muscle = configuration.ceres.muscle;
  muscle = SingleMuscleOptions::For(MuscleFormulation::kBlocks);
  ceres::Solver::Options& options = muscle.hard_constraint.ceres;
  if (name == "ceres_sparse_cholesky") {
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  } else if (name == "ceres_cgnr") {
    options.linear_solver_type = ceres::CGNR;
  } else if (name == "ceres_dogleg") {
    options.trust_region_strategy_type = ceres::DOGLEG;
  }
  return configuration;
}

GroupSolver SolverOf(const SolverConfiguration& configuration,
                     bool with_contact) {
  if (!with_contact) return EachOnItsOwn(MuscleSolverOf(configuration));
  return [&configuration](const std::vector<const MuscleModel*>& models,
                          const std::vector<MuscleTarget>& targets,
                          GroupContact* contact,
                          std::vector<MuscleState>* states,
                          std::vector<SolverSummary>* summaries) {
    if (configuration.is_reference) {
      SolveGaussNewtonGroup(models,
                            targets,
                            configuration.ceres.iteration,
                            contact,
                            states,
                            summaries);
    } else {
      SolveMuscleGroup(
          models, targets, configuration.ceres, contact, states, summaries);
    }
  };
}

}  // namespace musclewarp
