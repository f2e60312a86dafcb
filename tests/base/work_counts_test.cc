// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/work_counts.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <thread>
#include <vector>

namespace musclewarp {
namespace {

// Counts are of the whole process, so that tests look at what is added.
WorkCounts WorkSince(const WorkCounts& before) {
  WorkCounts added = WorkSoFar();
  for (size_t i = 0; i < added.size(); ++i) added[i] -= before[i];
  return added;
}

TEST(WorkCounts, EveryUnitHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int i = 0; i < kNumWorkUnits; ++i) {
    const std::string name = ToString(static_cast<WorkUnit>(i));
    EXPECT_FALSE(name.empty()) << i;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
}

TEST(WorkCounts, ACountForOneUnitLeavesTheOthers) {
  for (int i = 0; i < kNumWorkUnits; ++i) {
    const WorkCounts before = WorkSoFar();
    CountWork(static_cast<WorkUnit>(i), 3);
    CountWork(static_cast<WorkUnit>(i), 4);
    WorkCounts expected = {};
    expected[i] = 7;
    EXPECT_EQ(WorkSince(before), expected);
  }
}

TEST(WorkCounts, CountsOfSeveralThreadsAddUpExactly) {
  constexpr int kThreads = 4;
  constexpr int kCountsOfThread = 50000;
  const WorkCounts before = WorkSoFar();
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([i] {
      for (int k = 0; k < kCountsOfThread; ++k) {
        CountWork(WorkUnit::kPlanes, i + 1);
        CountWork(WorkUnit::kRows, 1);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  WorkCounts expected = {};
  expected[static_cast<size_t>(WorkUnit::kPlanes)] =
      kCountsOfThread * kThreads * (kThreads + 1) / 2;
  expected[static_cast<size_t>(WorkUnit::kRows)] = kCountsOfThread * kThreads;
  EXPECT_EQ(WorkSince(before), expected);
}

}  // namespace
}  // namespace musclewarp
