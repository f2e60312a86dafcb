// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/solver_configuration.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/paper_contact/gauss_newton_group.h"

namespace musclewarp {
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

MuscleSolvers SolversOf(const SolverConfiguration& configuration) {
  MuscleSolvers solvers;
  if (configuration.is_reference) {
    solvers.single = [options = configuration.gauss_newton](
                         const MuscleModel& model,
                         const MuscleTarget& target,
                         Points* coarse,
                         SolverSummary* summary) {
      SolveGaussNewton(model, target, options, coarse, summary);
    };
    solvers.group = [options = configuration.ceres.iteration](
                        const std::vector<const MuscleModel*>& models,
                        const std::vector<MuscleTarget>& targets,
                        GroupContact* contact,
                        std::vector<MuscleState>* states,
                        std::vector<SolverSummary>* summaries) {
      SolveGaussNewtonGroup(
          models, targets, options, contact, states, summaries);
    };
    return solvers;
  }
  solvers.single = [options = configuration.ceres.muscle](
                       const MuscleModel& model,
                       const MuscleTarget& target,
                       Points* coarse,
                       SolverSummary* summary) {
    SolveSingleMuscle(model, target, options, coarse, summary);
  };
  solvers.group = [options = configuration.ceres](
                      const std::vector<const MuscleModel*>& models,
                      const std::vector<MuscleTarget>& targets,
                      GroupContact* contact,
                      std::vector<MuscleState>* states,
                      std::vector<SolverSummary>* summaries) {
    SolveMuscleGroup(models, targets, options, contact, states, summaries);
  };
  return solvers;
}

}  // namespace musclewarp
