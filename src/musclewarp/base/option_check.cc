// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/option_check.h"

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/text.h"

namespace musclewarp {

OptionCheck& OptionCheck::IsAbove(const std::string& field,
                                  double value,
                                  double limit) {
  return Require(value > limit, field, value, "above " + NumberText(limit));
}

OptionCheck& OptionCheck::IsAtLeast(const std::string& field,
                                    double value,
                                    double limit) {
  return Require(value >= limit, field, value, NumberText(limit) + " or above");
}

OptionCheck& OptionCheck::IsWithin(const std::string& field,
                                   double value,
                                   double lowest,
                                   double highest) {
  return Require(lowest <= value && value <= highest,
                 field,
                 value,
                 NumberText(lowest) + " to " + NumberText(highest));
}

OptionCheck& OptionCheck::Require(bool holds,
                                  const std::string& field,
                                  double value,
                                  const std::string& rule) {
  if (!is_valid_ || holds) return *this;
  is_valid_ = false;
  *error_ = options_ + "::" + field + " is " + NumberText(value) +
            ", allowed: " + rule;
  return *this;
}

}  // namespace musclewarp
