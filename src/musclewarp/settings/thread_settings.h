// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/base/described.h"

namespace musclewarp {

// The setting of the number of threads.
struct ThreadSettings {
  int threads = 0;
};

constexpr auto FieldsOf(Described<ThreadSettings>) {
  // OpenMP ends the program if it cannot start the threads that are requested.
  constexpr int kMostThreads = 1024;
  return std::make_tuple(Field(&ThreadSettings::threads, "threads")
                             .Text("number of threads; 0: one a core")
                             .Within(0, kMostThreads)
                             .Changes(Effect::kNothing));
}

}  // namespace musclewarp
