// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace musclewarp {

// How far a long computation has come.
struct Progress {
  std::string stage;  // what is being done, such as "separating"
  int done = 0;       // of `total` parts of the stage
  int total = 0;      // 0: not known
  std::string item;   // what the part is about, such as a muscle; may be empty
};

// Called from time to time by long computations, always on the thread that
// called them and never inside a parallel loop or a solver. It may throw to
// stop the computation, which then leaves the state that the caller passed in
// as it was.
using ProgressCallback = std::function<void(const Progress& progress)>;

}  // namespace musclewarp
