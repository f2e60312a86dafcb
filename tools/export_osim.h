// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/exchange/path_fit.h"

namespace musclewarp {

struct OsimExportOptions {
  std::string model;
  PathFitOptions fit;
};

constexpr const char* HeadingOf(Described<OsimExportOptions>) {
  return "Path functions of an OpenSim model";
}

constexpr auto FieldsOf(Described<OsimExportOptions>) {
  using S = OsimExportOptions;
  using P = PathFitOptions;
  return std::make_tuple(
      Field(&S::model, "model")
          .Text("of osim: the model, in place of the one that the run keeps")
          .Path(),
      Field(Inner(&S::fit, &P::max_length_error), "max_length_error_mm", "mm")
          .Text("of osim: exit code 1 if a length is fitted worse")
          .Above(0),
      Field(Inner(&S::fit, &P::max_arm_error), "max_arm_error_mm", "mm")
          .Text("of osim: exit code 1 if a moment arm is fitted worse")
          .Above(0),
      NotWritten(&S::fit));
}

// Writes the OpenSim model of runs (folders separated by commas), in which
// functions replace the paths of the lines, and the errors of the fit to
// `screen` and to a file .fit.json beside the model. Returns kExitNotUsable if
// an error exceeds its bound. Throws InputError, naming the flag, file or
// field, before anything is written.
int ExportOsim(const std::string& runs,
               const std::string& out,
               const OsimExportOptions& options,
               std::ostream& screen);

}  // namespace musclewarp
