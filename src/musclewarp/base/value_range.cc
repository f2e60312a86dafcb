// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/value_range.h"

#include <cmath>
#include <sstream>

namespace musclewarp {

std::string ValueRange::Text() const {
  std::ostringstream text;
  const bool has_lowest = std::isfinite(lowest);
  const bool has_highest = std::isfinite(highest);
  if (has_lowest && is_open) {
    text << "above " << lowest;
    if (has_highest) text << ", at most " << highest;
  } else if (has_lowest) {
    text << lowest << (has_highest ? " to " : " or above");
    if (has_highest) text << highest;
  } else {
    text << "numbers";
    if (has_highest) text << " up to " << highest;
  }
  if (exception == exception) text << ", or " << exception;
  return text.str();
}

}  // namespace musclewarp
