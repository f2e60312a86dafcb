// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace musclewarp {
namespace {

TEST(AvailableMemory, IsSomeOfWhatTheMachineHas) {
  const double all = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                     static_cast<double>(sysconf(_SC_PAGE_SIZE));
  EXPECT_LT(AvailableMemory(), all);
  EXPECT_GT(AvailableMemory(), 0.01 * kBytesPerGib);  // or no test would run
}

}  // namespace
}  // namespace musclewarp
