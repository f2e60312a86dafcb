// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// The parts of the text of a flag between separators; none of an empty text.
std::vector<std::string> Split(const std::string& text, char separator);

}  // namespace musclewarp
