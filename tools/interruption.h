// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>

namespace musclewarp {

// While it lives, SIGINT and SIGTERM are noted instead of ending the program,
// so that it can stop where nothing is lost. A second one ends it at once.
class InterruptionScope {
 public:
  InterruptionScope();
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

 private:
  std::array<struct sigaction, 2> before_;
};

// Throws std::runtime_error that names the signal, if one was noted.
void ThrowIfInterrupted();

}  // namespace musclewarp
