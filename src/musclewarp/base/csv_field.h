// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns a text as a field of a CSV file (RFC 4180): in quotes if it holds a
// comma, a quote or a line break.
std::string CsvField(const std::string& text);

// Returns such a field that no spreadsheet takes for a formula: a text that
// begins with =, +, -, @, a tab or a carriage return has an apostrophe before
// it, as in the files of the page (tools/report/src/figures/downloads.ts). For
// names, not for numbers.
std::string SpreadsheetField(const std::string& text);

}  // namespace musclewarp
