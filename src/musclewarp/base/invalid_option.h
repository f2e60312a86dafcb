// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>

namespace musclewarp {

// Writes the message of an `IsValid(std::string* error)` that found a field
// outside of its range, and returns false, so that a rule is one statement:
//
//   if (!(step_threshold > 0)) {
//     return InvalidOption("GaussNewtonOptions::step_threshold",
//                          step_threshold, "above 0", error);
//   }
//
// The message names the field, the value seen and the rule:
// "GaussNewtonOptions::step_threshold is -1, allowed: above 0". `value` is
// anything that a stream prints. Precondition: `error` is not null.
template <typename Value>
bool InvalidOption(const std::string& field,
                   const Value& value,
                   const std::string& allowed,
                   std::string* error) {
  std::ostringstream message;
  message << field << " is " << value << ", allowed: " << allowed;
  *error = message.str();
  return false;
}

}  // namespace musclewarp
