// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// A table of texts with a header: comma-separated values as RFC 4180 has them,
// with LF or CRLF, and with or without a byte order mark.
class CsvTable {
 public:
  // Throws InputError that names the file and the line if the file cannot be
  // read, has no header, names a column twice, has a row of another length, or
  // a quote that does not end.
  explicit CsvTable(const std::string& path);

  std::size_t NumRows() const { return rows_.size(); }

  // Throws InputError that names the columns that are missing.
  void Require(const std::vector<std::string>& columns) const;

  // Returns a field, or an empty text if there is no such column.
  std::string Text(std::size_t row, const std::string& column) const;

  // Returns a field as a number; nothing if it is empty. Throws InputError that
  // names the line and the column if it is no finite number.
  std::optional<double> Number(std::size_t row,
                               const std::string& column) const;

 private:
  struct Row {
    int line;
    std::vector<std::string> fields;
  };

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace musclewarp
