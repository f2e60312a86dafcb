// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "musclewarp/base/infinity.h"

namespace musclewarp {

// The numbers that are allowed for a field.
struct ValueRange {
  double lowest = -kInfinity;
  double highest = kInfinity;
  bool is_open = false;  // if true, `lowest` itself is not allowed

  // A value beside the range that is allowed, too, or NaN.
  double also_allowed = std::numeric_limits<double>::quiet_NaN();

  constexpr bool Contains(double value) const {
    return value == also_allowed ||
           (value <= highest && (is_open ? value > lowest : value >= lowest));
  }

  // Returns "0 or above", "above 0, at most 0.5", "0 to 1", "numbers", ...
  std::string Text() const;
};

}  // namespace musclewarp
