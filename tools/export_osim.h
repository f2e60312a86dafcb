// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/exchange/path_fit.h"

namespace musclewarp {

struct OsimExportOptions {
  std::string model;  // the .osim; empty: that of the run
  PathFitOptions fit;
};

// Writes the OpenSim model of runs (folders with commas between) with the paths
// of their lines as functions, and the errors of the fit beside it in .fit.json
// and on `screen`. Returns kExitNotUsable if an error exceeds its bound. Throws
// InputError that names the flag, file or field; nothing is written then.
int ExportOsim(const std::string& runs,
               const std::string& out,
               const OsimExportOptions& options,
               std::ostream& screen);

}  // namespace musclewarp
