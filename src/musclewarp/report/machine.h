// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// What figures of time depend on.
struct Machine {
  std::string processor;  // "unknown" where the system does not say
  int cores = 0;
  int threads = 0;  // used by this run
};

Machine ThisMachine();

}  // namespace musclewarp
