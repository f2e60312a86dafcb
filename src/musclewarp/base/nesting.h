// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/input_error.h"

namespace musclewarp {

// How deep elements of a file may be in each other: readers that follow them
// inward need memory of the stack for each.
constexpr int kDeepestNesting = 1000;

// Throws InputError if a file is nested deeper.
inline void CheckNesting(const std::string& file, int depth) {
  if (depth <= kDeepestNesting) return;
  throw InputError(file,
                   "has elements that are more than " +
                       std::to_string(kDeepestNesting) + " deep in each other",
                   "the file is damaged or of another kind");
}

}  // namespace musclewarp
