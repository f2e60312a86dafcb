// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace musclewarp {

// Returns texts with commas between them, for a message of one line. Of more
// than `most` the first are named, and the others counted: "a, b and 7 more".
std::string ShortList(const std::vector<std::string>& texts,
                      std::size_t most = 10);

}  // namespace musclewarp
