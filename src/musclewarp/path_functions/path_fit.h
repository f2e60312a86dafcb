// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/path_functions/path_function.h"
#include "musclewarp/path_functions/path_sample.h"

namespace musclewarp {

struct PathFitOptions {
  // Errors of this size count alike, of a length (mm) and of a moment arm (mm
  // per rad or m).
  double length_error = 0.3;
  double arm_error = 1;

  // Samples are divided into so many groups for cross-validation, or into one
  // group each if there are fewer.
  int groups = 10;

  bool IsValid(std::string* error) const;
};

// Absolute errors; 0 if there are none.
struct ErrorFigures {
  double mean = 0;
  double rms = 0;
  double quantile_95 = 0;
  double largest = 0;
  int worst_sample = -1;  // where the largest is
};

// How far a fit is from samples.
struct PathErrors {
  ErrorFigures length;  // mm
  ErrorFigures arm;     // of all coordinates, mm per rad or m
};

// A path as a function of coordinates.
struct PathFit {
  PathFunction path;

  // At samples that the function does not know: those of each group by a
  // function whose terms were chosen and fitted without the group. `at_samples`
  // are the errors at the samples of which the function is made.
  PathErrors held_back;
  PathErrors at_samples;
};

// Fits a polynomial of some coordinates to lengths and moment arms together, by
// least squares. Terms are added, each time the one that explains most, as long
// as they improve the prediction of groups that are held back
// (cross-validation); a term comes with those that have one degree less of a
// coordinate. What no sample determines is zero: a coordinate that does not
// vary enters by its arms only. Samples whose numbers have the same remainder
// by PathFitOptions::groups are a group.
//
// `coordinates`: ascending indices into those of the samples. Preconditions
// (CHECKed): there is a sample, and there are 1 to kMostPathCoordinates
// coordinates.
PathFit FitPath(const std::vector<PathSample>& samples,
                const std::vector<int>& coordinates,
                const PathFitOptions& options = {});

}  // namespace musclewarp
