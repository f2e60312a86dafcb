// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace musclewarp {

// Measures the wall time since its construction, for reports; no result may
// depend on it.
class Stopwatch {
 public:
  // Returns the time since construction, ms.
  double Milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_)
        .count();
  }

  // Starts again at zero.
  void Restart() { start_ = Clock::now(); }

 private:
  // A clock that is not set back when the time of day is adjusted.
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace musclewarp
