// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// A table over time as OpenSim and SIMM keep it (.sto, .mot): a header, a line
// of labels, rows of numbers. Values are as in the file, not converted.
struct StorageTable {
  std::string name;
  // Whether angles are in degrees; nothing if the header does not say.
  std::optional<bool> in_degrees;
  std::vector<std::string> labels;  // without "time"
  std::vector<double> times;        // s, rising
  Eigen::MatrixXd values;           // #times x #labels
  // Where the header and the rows disagree.
  std::vector<std::string> warnings;
};

// Reads "key=value" headers of any version up to "endheader", and the older
// "datarows 12" of SIMM. A wrong number of rows or columns in the header is a
// warning: what is there counts. Throws InputError with file and line: no
// "endheader", no "time" column, a label twice, a row with too few or too many
// values, text or NaN in a row, times that do not rise, no row.
StorageTable ReadStorageTable(const std::string& path);

// The file, readable by OpenSim's Storage and TimeSeriesTable. Preconditions
// (CHECKed): sizes agree, labels are not empty, hold no blanks and differ.
std::string StorageText(const StorageTable& table);

}  // namespace musclewarp
