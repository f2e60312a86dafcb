// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/motion/group_solver.h"
#include "musclewarp/solver/gauss_newton.h"
#include "problems/muscle_group/muscle_group_solver.h"

namespace musclewarp {

// A solver with all its options, by name.
struct SolverConfiguration {
  std::string name;
  bool is_reference = false;
  GaussNewtonOptions gauss_newton;  // of the reference, without contact
  MuscleGroupOptions ceres;         // its iteration is the reference's, too

  bool IsValid(std::string* error) const;
};

// reference: Gauss-Newton with Lagrange multiplier. ceres: whitened unknowns,
// the default. ceres_dense_cholesky, ceres_sparse_cholesky, ceres_cgnr: plain
// blocks with that linear solver; ceres_dogleg: plain blocks, dense Cholesky,
// dogleg steps.
const std::vector<std::string>& SolverConfigurationNames();

// Precondition (CHECKed): one of the names.
SolverConfiguration SolverConfigurationNamed(const std::string& name);

// Keeps a reference to the configuration.
GroupSolver SolverOf(const SolverConfiguration& configuration,
                     bool with_contact);

}  // namespace musclewarp
