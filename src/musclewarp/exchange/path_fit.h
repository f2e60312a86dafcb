// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/opensim/multivariate_polynomial.h"

namespace musclewarp {

// What a run measured of a path in a frame.
struct PathSample {
  Eigen::VectorXd coordinates;  // rad or m
  double length = 0;            // mm
  Eigen::VectorXd arms;         // -dl/dq of each coordinate, mm per rad or m
};

// How far a fit is from the samples.
struct PathErrors {
  double length_max = 0, length_rms = 0;  // mm
  double arm_max = 0, arm_rms = 0;        // mm per rad or m
};

struct PathFitOptions {
  // The order rises until the largest errors are at most these.
  double max_length_error = 0.5;  // mm
  double max_arm_error = 1;       // mm per rad or m
};

// A path as a function of the coordinates.
struct PathFit {
  // The coordinates on which the path depends, ascending indices into those of
  // the samples.
  std::vector<int> coordinates;
  MultivariatePolynomial length;  // mm
  PathErrors errors;
  bool within_bounds = false;
};

// Fits a polynomial to lengths and moment arms together, by least squares
// weighted with the bounds. Coordinates without an arm of at least 1e-3 mm in
// any sample are left out. The order is the smallest one with errors within the
// bounds, else that with the smallest errors. Of all best polynomials the one
// with the smallest coefficients is taken, about the median of the samples and
// scaled by their range: what the samples do not determine is zero. A
// coordinate that does not vary enters by its arms only, so linearly.
// Precondition (CHECKed): there is a sample, and all have the same number of
// coordinates.
//
// Throws InputError with `name` if the path depends on no coordinate, or on
// more than OpenSim's polynomials can have.
PathFit FitPath(const std::string& name,
                const std::vector<PathSample>& samples,
                const PathFitOptions& options);

}  // namespace musclewarp
