// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/csv_field.h"

namespace musclewarp {

std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string SpreadsheetField(const std::string& text) {
  const bool is_formula = text.find_first_of("=+-@\t\r") == 0;
  return CsvField(is_formula ? "'" + text : text);
}

}  // namespace musclewarp
