// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/solver/gauss_newton.h"
#include "problems/muscle_group/muscle_group_solver.h"

namespace musclewarp {

// Which solver moves the muscles, with all its options, by name. The default is
// the one to use; the others are there to be compared with it.
struct SolverConfiguration {
  std::string name = "ceres";
  bool is_reference = false;
  GaussNewtonOptions gauss_newton;  // of the reference, without contact
  MuscleGroupOptions ceres;  // the reference takes its iteration limits, too

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

// Returns the names of all configurations:
//
//   reference               Gauss-Newton with Lagrange multiplier (the paper)
//   ceres                   Ceres on whitened unknowns, the default
//   ceres_dense_cholesky    Ceres on plain blocks with that linear solver
//   ceres_sparse_cholesky
//   ceres_cgnr
//   ceres_dogleg            plain blocks, dense Cholesky, dogleg steps
const std::vector<std::string>& SolverConfigurationNames();

// Precondition (CHECKed): it is one of the names.
SolverConfiguration SolverConfigurationNamed(const std::string& name);

// Returns the solvers of a configuration, which is copied.
MuscleSolvers SolversOf(const SolverConfiguration& configuration);

}  // namespace musclewarp
