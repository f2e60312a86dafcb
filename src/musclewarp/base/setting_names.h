// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Messages of the library name a setting in braces, "{max_hole}", since its
// name depends on the caller: programs know it as the flag "--max_hole", C++
// and Python as "max_hole".

#include <string>
#include <vector>

namespace musclewarp {

// Return texts with their settings named as flags, and as fields or keywords.
std::string WithFlags(const std::string& text);
std::string WithFieldNames(const std::string& text);
std::vector<std::string> WithFieldNames(std::vector<std::string> texts);

}  // namespace musclewarp
