// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Returns the parts of the text of a flag between separators, in their order.
// Parts may be empty, but not the last: "a,,b" has three parts, "a," has one,
// and an empty text has none.
std::vector<std::string> Split(const std::string& text, char separator);

}  // namespace musclewarp
