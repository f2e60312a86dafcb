// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/checked_settings.h"

#include "musclewarp/base/text.h"

namespace musclewarp {

void CheckChoice(const char* name,
                 const std::string& value,
                 const std::string& choices) {
  const std::string listed = ", " + choices + ",";
  if (choices.empty() ||
      (value.find(',') == std::string::npos &&
       listed.find(", " + value + ",") != std::string::npos)) {
    return;
  }
  throw InputError("{" + std::string(name) + "}=" + value,
                   "is none of its values",
                   "allowed: " + choices);
}

void CheckNumber(const char* name,
                 double value,
                 const ValueRange& range,
                 const std::string& unit) {
  constexpr int kDigits = 15;  // of a number as it was given
  if (std::isfinite(value) && range.Contains(value)) return;
  throw InputError(
      "{" + std::string(name) + "}",
      "is " + NumberText(value, kDigits),
      "allowed: " + range.Text() + (unit.empty() ? "" : ", ") + unit);
}

}  // namespace musclewarp
