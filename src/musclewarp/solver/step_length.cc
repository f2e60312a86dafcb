// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/step_length.h"

#include <algorithm>

#include "musclewarp/base/invalid_option.h"

namespace musclewarp {

double StepLengthSchedule::Next(double alpha) const {
  return std::max(final_alpha, alpha * decay);
}

bool StepLengthSchedule::IsValid(std::string* error) const {
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption("StepLengthSchedule::" + field, value, allowed, error);
  };
  if (!(0 < initial_alpha && initial_alpha <= 1)) {
    return fail("initial_alpha", initial_alpha, "above 0 and at most 1");
  }
  if (!(0 < final_alpha && final_alpha <= initial_alpha)) {
    return fail(
        "final_alpha", final_alpha, "above 0 and at most initial_alpha");
  }
  if (!(0 < decay && decay <= 1)) {
    return fail("decay", decay, "above 0 and at most 1");
  }
  return true;
}

}  // namespace musclewarp
