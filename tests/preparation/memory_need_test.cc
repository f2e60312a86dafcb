// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/memory_need.h"

#include <gtest/gtest.h>

#include "musclewarp/base/memory.h"
#include "support/input_errors.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

const std::vector<SizedMesh> kMeshes = {
    {"psoas", 1000, true}, {"soleus", 4000, true}, {"femur", 3000, false}};

TEST(MemoryNeed, GrowsWithEveryMesh) {
  const double needed = MemoryNeeded(kMeshes, 200, true);
  for (size_t i = 0; i < kMeshes.size(); ++i) {
    std::vector<SizedMesh> larger = kMeshes;
    larger[i].vertices *= 2;
    EXPECT_GT(MemoryNeeded(larger, 200, true), needed);
  }
  EXPECT_GT(MemoryNeeded(kMeshes, 400, true), needed);
  EXPECT_LT(MemoryNeeded(kMeshes, 200, false), needed);
}

TEST(MemoryNeed, MoreThanIsAllowedIsRefused) {
  const double needed = 3 * kBytesPerGib;
  CheckMemory(kMeshes, needed, needed);
  ExpectInputError([&] { CheckMemory(kMeshes, needed, 0.75 * needed); },
                   {"max_memory_gib",
                    "needs about 3.00 GiB",
                    "allowed: 2.25 GiB",
                    "soleus takes most (4000 vertices)"});
}

TEST(MemoryNeed, ASceneIsRefusedBeforeItIsPrepared) {
  PrepareOptions options;
  const double needed = PrepareScene(SmallScene(), options).memory_needed;
  EXPECT_GT(needed, 0);
  options.max_memory = 0.99 * needed;
  ExpectInputError([&] { PrepareScene(SmallScene(), options); },
                   {"max_memory_gib"});
}

}  // namespace
}  // namespace musclewarp
