// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The machine that a run was timed on. Times are worth little without it.
struct Machine {
  std::string processor;  // "unknown" if the system does not name it
  int cores = 0;
  int threads = 0;  // that this run uses
};

// Returns what the system says of this machine.
Machine ThisMachine();

}  // namespace musclewarp
