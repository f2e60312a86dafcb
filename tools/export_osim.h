// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/exchange/fitted_paths.h"

namespace musclewarp {

// The settings of path functions, for fit, osim and mjcf.
struct PathExportOptions {
  std::string model;
  int paths_per_muscle = 0;
  PathBounds bounds;
  double max_skin_distance = 2;  // mm
};

constexpr const char* HeadingOf(Described<PathExportOptions>) {
  return "Path functions";
}

constexpr auto FieldsOf(Described<PathExportOptions>) {
  using S = PathExportOptions;
  using B = PathBounds;
  return std::make_tuple(
      Field(&S::model, "model")
          .Text("of fit, mjcf and osim: the model, in place of the one that "
                "the run "
                "keeps")
          .Path(),
      Field(&S::paths_per_muscle, "paths_per_muscle")
          .Text("of fit, mjcf and osim: paths of each muscle, bands of its "
                "fibres; 0: "
                "its lines")
          .Within(0, 100),
      Field(
          Inner(&S::bounds, &B::max_length_error), "max_length_error_mm", "mm")
          .Text(
              "of fit, mjcf and osim: exit code 1 if lengths at frames that a "
              "function does not know are worse on the mean")
          .Above(0),
      Field(Inner(&S::bounds, &B::max_arm_error), "max_arm_error_mm", "mm")
          .Text("of fit, mjcf and osim: the same of moment arms")
          .Above(0),
      Field(Inner(&S::bounds, &B::largest_arm_error),
            "largest_arm_error_mm",
            "mm")
          .Text("of fit, mjcf and osim: exit code 1 if one of these moment "
                "arms is "
                "worse")
          .Above(0),
      Field(&S::max_skin_distance, "max_skin_distance_mm", "mm")
          .Text("of mjcf: skins that are farther from the frames on the mean "
                "get slides, which are bodies and joints of their own; large "
                "values: none")
          .Above(0),
      NotWritten(&S::bounds));
}

// Returns what is written of the functions of runs (folders separated by
// commas) beside `out`: fit.json.
nlohmann::ordered_json PathRecord(const std::string& runs,
                                  const std::string& out,
                                  const RunPaths& paths,
                                  const FittedPaths& fitted,
                                  const PathBounds& bounds);

// Writes the functions of all paths of runs (folders separated by commas) and
// their errors to a .json file, and the errors to `screen`. Returns
// kExitNotUsable if an error exceeds its bound. Throws InputError, naming the
// flag, file or field, before anything is written.
int ExportFit(const std::string& runs,
              const std::string& out,
              const PathExportOptions& options,
              std::ostream& screen);

// Writes the OpenSim model of runs, in which functions replace the paths of
// muscles, and does the same as ExportFit() with a file .fit.json beside the
// model.
int ExportOsim(const std::string& runs,
               const std::string& out,
               const PathExportOptions& options,
               std::ostream& screen);

}  // namespace musclewarp
