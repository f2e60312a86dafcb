// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/option_check.h"

#include <sstream>

#include "musclewarp/base/invalid_option.h"

namespace musclewarp {
namespace {

// 6 digits, without trailing zeros.
std::string TextOf(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

OptionCheck& OptionCheck::IsAbove(const std::string& field,
                                  double value,
                                  double limit) {
  return Require(value > limit, field, value, "above " + TextOf(limit));
}

OptionCheck& OptionCheck::IsAtLeast(const std::string& field,
                                    double value,
                                    double limit) {
  return Require(value >= limit, field, value, TextOf(limit) + " or above");
}

OptionCheck& OptionCheck::IsWithin(const std::string& field,
                                   double value,
                                   double lowest,
                                   double highest) {
  return Require(lowest <= value && value <= highest,
                 field,
                 value,
                 TextOf(lowest) + " to " + TextOf(highest));
}

OptionCheck& OptionCheck::Require(bool holds,
                                  const std::string& field,
                                  double value,
                                  const std::string& rule) {
  if (!is_valid_ || holds) return *this;
  is_valid_ = false;
  *error_ =
      options_ + "::" + field + " is " + TextOf(value) + ", allowed: " + rule;
  return *this;
}

}  // namespace musclewarp
