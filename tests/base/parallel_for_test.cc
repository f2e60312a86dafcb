// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/parallel_for.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace musclewarp {
namespace {

TEST(ParallelFor, CallsEveryNumberOnce) {
  std::vector<int> calls(1000, 0);
  ParallelFor(calls.size(), [&](size_t i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(calls.size(), 1));
}

TEST(ParallelFor, OfNothingCallsNothing) {
  ParallelFor(0, [](size_t) { FAIL(); });
}

TEST(ParallelFor, ThrowsWhatTheLowestNumberThrew) {
  for (int trial = 0; trial < 100; ++trial) {
    try {
      ParallelFor(100, [](size_t i) {
        if (i % 7 == 5) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "5");
    }
  }
}

}  // namespace
}  // namespace musclewarp
