// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "tools/export_osim.h"

namespace musclewarp {

// Writes a model for MuJoCo to the folder `out`: model.xml, the meshes of bones
// and the skins of muscles in assets/, and model.fit.json with the functions
// that tendons follow and all errors, which `screen` has too. `runs` are
// folders separated by commas; bones, lines and skins are those of the first.
// Returns kExitNotUsable if a function exceeds its bounds. Throws InputError,
// naming the flag, file or field, before anything is written.
int ExportMjcf(const std::string& runs,
               const std::string& out,
               const PathExportOptions& options,
               std::ostream& screen);

}  // namespace musclewarp
