// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/parallel_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>
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

TEST(ParallelFor, SaysOnTheCallingThreadHowManyAreDone) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<size_t> done;
  ParallelFor(
      100,
      [](size_t) {},
      [&](size_t i, size_t count) {
        EXPECT_LT(i, 100u);
        EXPECT_EQ(std::this_thread::get_id(), caller);
        done.push_back(count);
      });
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  for (const size_t count : done) EXPECT_LT(count, 100u);
}

TEST(ParallelFor, MayBeStoppedInBetween) {
  const auto stop = [](size_t, size_t) { throw std::runtime_error("stopped"); };
  EXPECT_THROW(ParallelFor(
                   1, [](size_t) { FAIL(); }, stop),
               std::runtime_error);
}

}  // namespace
}  // namespace musclewarp
