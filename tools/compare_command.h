// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/deformer/solver_configuration.h"
#include "tools/deform_command.h"

namespace musclewarp {

struct CompareOptions {
  // Scene, frames, preparation and contact; its solver and formats are not
  // used.
  DeformOptions deform;
  std::vector<SolverConfiguration> configurations;
  std::vector<ContactKind> contacts = {ContactKind::kNone};
  int repeat = 1;  // runs of each, of which the median time is given
};

// "all" or names with commas; InputError names what is allowed.
std::vector<SolverConfiguration> ParseConfigurations(const std::string& text);
std::vector<ContactKind> ParseContacts(const std::string& text);

// Solves the poses of a scene with every configuration, with and without
// contact, and prints a table; with an output folder also writes
// comparison.csv, comparison.json and history.csv. The first of the
// configurations that is the reference is what the others are compared with. A
// configuration that fails is a row that says so. Returns an exit code: 0 when
// the table is complete. Throws InputError, before anything is written, for bad
// input.
int CompareCommand(const CompareOptions& options, std::ostream& screen);

}  // namespace musclewarp
