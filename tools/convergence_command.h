// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/convergence_study.h"
#include "tools/deform_command.h"

namespace musclewarp {

struct ConvergenceOptions {
  // Scene, frames, preparation, contact and solver; its formats are not used.
  DeformOptions deform;
  StudyValues values;
};

// Return the values of a flag: numbers with commas, in any order; an empty text
// has none. Throw InputError that names the flag and what is allowed.
std::vector<int> ParseConvergenceVertices(const std::string& text);
std::vector<double> ParseConvergenceSpacing(const std::string& text);
std::vector<double> ParseConvergenceDensity(const std::string& text);

// Returns the contact of a study. Throws InputError, naming --contact, unless
// it is none or certified.
ContactKind ParseConvergenceContact(const std::string& text);

// Solves the selected frames of a scene once for every discretisation of the
// studies, and prints how far each is from the finest of its study; with an
// output folder also writes convergence.csv and convergence.json. The
// discretisation that the options set is always among them. One that fails is a
// row that says so. Returns an exit code: 0 when the tables are complete.
// Throws InputError, before anything is written, for bad input.
int ConvergenceCommand(const ConvergenceOptions& options, std::ostream& screen);

}  // namespace musclewarp
