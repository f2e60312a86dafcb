// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/solver/gauss_newton.h"
#include "problems/muscle_group/muscle_group_solver.h"

namespace musclewarp {

// The solver that moves the muscles, selected by name, with its options. The
// default is recommended; the others serve for comparison.
struct SolverConfiguration {
  std::string name = "ceres";
  bool is_reference = false;
  GaussNewtonOptions gauss_newton;  // of the reference, without contact
  // With contact, the reference uses the iteration limits of these, too.
  MuscleGroupOptions ceres;

  // Also checks the nested options.
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

// Returns the configuration with a name. Precondition (CHECKed): `name` is one
// of SolverConfigurationNames().
SolverConfiguration SolverConfigurationNamed(const std::string& name);

// Returns the solvers of a configuration. The configuration is copied.
MuscleSolvers SolversOf(const SolverConfiguration& configuration);

}  // namespace musclewarp
