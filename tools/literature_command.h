// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/described.h"

namespace musclewarp {

// The settings of a comparison with measured moment arms.
struct LiteratureSettings {
  std::string literature;
};

constexpr const char* HeadingOf(Described<LiteratureSettings>) {
  return "Measured moment arms";
}

constexpr auto FieldsOf(Described<LiteratureSettings>) {
  using S = LiteratureSettings;
  return std::make_tuple(
      Field(&S::literature, "literature")
          .Text("CSV table of measured moment arms, with which those of the "
                "run {in} are compared")
          .Path());
}

struct LiteratureOptions : LiteratureSettings {
  std::string in;   // folder of a run
  std::string out;  // folder for literature.csv, or empty
};

// Compares the moment arms of a run with measured ones (ScoreArms): prints a
// row for each muscle and coordinate, and writes literature.csv if there is an
// output folder. Returns 0, whatever holds. Throws InputError, before anything
// is written, for bad input, and if nothing in the table is of the run.
int LiteratureCommand(const LiteratureOptions& options, std::ostream& screen);

}  // namespace musclewarp
