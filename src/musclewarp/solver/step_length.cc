// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/step_length.h"

#include <algorithm>

namespace musclewarp {

double StepLengthSchedule::After(double alpha) const {
  return std::max(final_alpha, alpha * decay);
}

bool StepLengthSchedule::IsValid(std::string* error) const {
  if (!(0 < final_alpha && final_alpha <= initial_alpha &&
        initial_alpha <= 1)) {
    *error =
        "StepLengthSchedule: allowed: 0 < final_alpha <= initial_alpha <= 1";
    return false;
  }
  if (!(0 < decay && decay <= 1)) {
    *error = "StepLengthSchedule: allowed: 0 < decay <= 1";
    return false;
  }
  return true;
}

}  // namespace musclewarp
