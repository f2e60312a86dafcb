// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/deformer/solver_configuration.h"
#include "musclewarp/settings/deformer_settings.h"
#include "tools/deform_command.h"

namespace musclewarp {

// The settings that a comparison of solvers has in addition to those of the
// scene.
struct CompareSettings {
  std::string configurations = "all";
  std::string contact = "none";
  std::string out;
  int repeat = 1;
};

constexpr const char* HeadingOf(Described<CompareSettings>) {
  return "Comparison";
}

constexpr auto FieldsOf(Described<CompareSettings>) {
  using S = CompareSettings;
  return std::make_tuple(
      Field(&S::configurations, "configurations")
          .Text("solvers to compare: all, or names with commas: reference, "
                "ceres (whitened unknowns), and plain blocks with "
                "ceres_dense_cholesky, ceres_sparse_cholesky, ceres_cgnr, "
                "ceres_dogleg"),
      Field(&S::contact, "contact")
          .Text("none, paper, certified, or several with commas")
          .OneOf("certified, paper, none; commas"),
      Field(&S::out, "out")
          .Text("folder for comparison.csv, comparison.json and history.csv, "
                "for convergence.csv and convergence.json, or for posture.json "
                "and posture.vtp; without it the table is only printed")
          .Path()
          .Changes(Effect::kNothing),
      Field(&S::repeat, "repeat")
          .Text("number of runs of each, of which the median time is given")
          .AtLeast(1)
          .Changes(Effect::kNothing));
}

struct CompareOptions {
  // The scene, its frames, preparation and contact. The solver and the formats
  // are not used.
  DeformOptions deform;
  std::vector<SolverConfiguration> configurations;
  std::vector<ContactKind> contacts = {ContactKind::kNone};
  int repeat = 1;  // solves of each frame; their median time is reported
};

// Return the values of a text: "all", or names separated by commas. Throw
// InputError, which lists the allowed names, for any other name.
std::vector<SolverConfiguration> ParseConfigurations(const std::string& text);
std::vector<ContactKind> ParseContacts(const std::string& text);

// Solves the poses of a scene with every configuration, with and without
// contact, and prints a table; with an output folder, also writes
// comparison.csv, comparison.json and history.csv. The first configuration that
// is the reference is the one that the others are compared with. The row of a
// configuration that failed states the failure. Returns an exit code: 0 if the
// table is complete. Throws InputError, before anything is written, for bad
// input.
int CompareCommand(const CompareOptions& options, std::ostream& screen);

}  // namespace musclewarp
