// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// A table over time, as OpenSim and SIMM write them to .sto and .mot files: a
// header, a line of labels, and rows of numbers. Values are those of the file;
// degrees and metres are not converted.
struct StorageTable {
  std::string name;

  // Whether angles are in degrees, without a value if the header does not say.
  std::optional<bool> in_degrees;

  std::vector<std::string> labels;  // of the columns, without "time"
  std::vector<double> times;        // s, strictly ascending
  Eigen::MatrixXd values;           // #times x #labels; may have NaN

  // The lines of the file in which the rows are; empty for a table that was
  // not read from one.
  std::vector<int> lines;

  // Sentences about where the header and the rows of the file disagree.
  std::vector<std::string> warnings;
};

// Reads a table from a file. The header may be of any version: lines
// "key=value" up to "endheader", or the older "datarows 12" of SIMM. If it
// states a wrong number of rows or columns, there is a warning, and the rows
// that the file has are used. A row that is the one before once more, as RRA
// writes the last one, is left out, with a warning.
//
// Labels may occur twice and values may be NaN or infinite, as in the columns
// of forces that real files have: what needs a column has to check it.
//
// Throws InputError, which names the file and the line, if there is no
// "endheader", no column "time" or no row, if a row has too few or too many
// values or one that is not a number, or if times do not ascend.
StorageTable ReadStorageTable(const std::string& path);

// Returns the text of a file that ReadStorageTable and OpenSim's Storage and
// TimeSeriesTable can read. Numbers are written so that reading them gives the
// same values. Preconditions (CHECKed): there are as many times as rows and as
// many labels as columns; labels are different, not empty and without blanks.
std::string StorageText(const StorageTable& table);

}  // namespace musclewarp
