// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns a text as a field of a CSV file (RFC 4180): in quotes if it holds a
// comma, a quote or a line break.
std::string CsvField(const std::string& text);

}  // namespace musclewarp
