// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/value_range.h"

#include <cmath>
#include <sstream>

namespace musclewarp {
namespace {

// Returns a number as one writes it: "0.5", "1e6".
std::string Written(double number) {
  std::ostringstream text;
  text << number;
  std::string written = text.str();
  const size_t exponent = written.find("e+0");
  if (exponent != std::string::npos) written.erase(exponent + 1, 2);
  return written;
}

}  // namespace

std::string ValueRange::Text() const {
  std::ostringstream text;
  const bool has_lowest = std::isfinite(lowest);
  const bool has_highest = std::isfinite(highest);
  if (has_lowest && is_open) {
    text << "above " << Written(lowest);
    if (has_highest) text << ", at most " << Written(highest);
  } else if (has_lowest) {
    text << Written(lowest) << (has_highest ? " to " : " or above");
    if (has_highest) text << Written(highest);
  } else {
    text << "numbers";
    if (has_highest) text << " up to " << Written(highest);
  }
  if (also_allowed == also_allowed) text << ", or " << Written(also_allowed);
  return text.str();
}

}  // namespace musclewarp
