// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The length alpha of steps, X <- X + alpha h: starts at the first, is
// multiplied by the decay after every iteration and never falls below the last.
// The paper gives the two ends.
struct StepLengthSchedule {
  double initial_alpha = 0.5;
  double final_alpha = 0.125;
  double decay = 0.9;

  double After(double alpha) const;
  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
