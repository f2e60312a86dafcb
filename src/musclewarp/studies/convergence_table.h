// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/studies/convergence_study.h"

namespace musclewarp {

// Returns "hulls of 200 vertices", "samples every 10 mm" or "meshes of density
// 1".
std::string Describe(StudyKind study, double value);

// Prints the rows as tables for the screen, one per study.
void PrintConvergence(const std::vector<ConvergenceRow>& rows,
                      std::ostream& out);

// Prints for each muscle the largest errors, over all frames, of the
// discretisation that the flags set:
//
//   psoas: hulls of 200 vertices: 0.06 mm on the mean, 1.27 mm at most, from
//   2400; samples every 10 mm: ...
void PrintErrors(const std::vector<ConvergenceRow>& rows, std::ostream& out);

// Returns the rows as CSV, one line each.
std::string ConvergenceCsv(const std::vector<ConvergenceRow>& rows);

// Returns the rows of convergence.json.
nlohmann::ordered_json ConvergenceJson(const std::vector<ConvergenceRow>& rows);

}  // namespace musclewarp
