// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The step length alpha of the iterations X <- X + alpha h. It starts at
// initial_alpha, is multiplied by decay after every iteration and never falls
// below final_alpha. The two ends are the paper's; it does not give the decay.
//
//   for (double alpha = schedule.initial_alpha;;) {
//     ... X += alpha * h ...
//     alpha = schedule.Next(alpha);
//   }
struct StepLengthSchedule {
  double initial_alpha = 0.5;
  double final_alpha = 0.125;
  double decay = 0.9;

  // Returns the step length of the iteration after one with `alpha`.
  double Next(double alpha) const;

  // Returns false and names the field, its value and the rule unless
  // 0 < final_alpha <= initial_alpha <= 1 and 0 < decay <= 1.
  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
