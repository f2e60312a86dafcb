// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/exchange/run_paths.h"
#include "musclewarp/path_functions/path_fit.h"
#include "musclewarp/path_functions/path_survey.h"

namespace musclewarp {

// What the function of a path has to hold, at samples that it does not know.
struct PathBounds {
  double max_length_error = 0.5;  // on the mean, mm
  double max_arm_error = 1;       // on the mean, mm per rad or m
  double largest_arm_error = 5;   // of all arms, mm per rad or m
};

// A measured path and its function.
struct FittedPath {
  const MeasuredPath* path = nullptr;
  PathFit fit;
  PathSurvey survey;
  bool within_bounds = false;
};

// The functions of all paths of runs.
struct FittedPaths {
  std::vector<FittedPath> paths;

  // Paths that cross no coordinate that the runs have, and so have no function.
  std::vector<std::string> without_coordinates;

  // The time of one evaluation of all functions, with their arms.
  double microseconds = 0;

  bool AreWithinBounds() const;
};

// Fits a function to every path (FitPath) and surveys it on kSurveyLines lines.
// With a single sample, the bounds are held against the error there. The result
// refers to `paths`, and is the same for any number of threads, but for the
// time. Throws InputError if a path crosses more than kMostPathCoordinates.
FittedPaths FitPaths(const RunPaths& paths, const PathBounds& bounds);

constexpr int kSurveyLines = 500;

// Returns the record of the functions and their errors: fit.json
// (docs/export.md).
nlohmann::ordered_json FitJson(const RunPaths& paths,
                               const FittedPaths& fitted,
                               const PathBounds& bounds);

// Prints a line for each function, what was left out, and the time.
void PrintFits(const RunPaths& paths,
               const FittedPaths& fitted,
               std::ostream& screen);

}  // namespace musclewarp
