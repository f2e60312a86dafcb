// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/memory_limits.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A ball of many small triangles, and one that is an elephant's.
TEST(MemoryLimits, AreNotReachedByMuscles) {
  const SearchableMesh ball(Icosphere(40, 5));
  EXPECT_NO_THROW(CheckContactFits({{"psoas", &ball}}, 1.5, 1.7));
}

TEST(MemoryLimits, NameALatticeThatIsTooLarge) {
  const SearchableMesh box(Box(5000, 3000, 3000));
  ExpectInputError(
      [&] {
        CheckContactFits({{"psoas", &box}}, 1.5, 1.7);
      },
      {"psoas", "3333 x 2000 x 2000 samples", "unit"});
}

TEST(MemoryLimits, NameTrianglesThatAreTooSmall) {
  const SearchableMesh ball(Icosphere(0.3, 6));
  ExpectInputError(
      [&] {
        CheckContactFits({{"psoas", &ball}}, 1.5, 1.7);
      },
      {"psoas", "81920 triangles", "pairs", "larger"});
}

}  // namespace
}  // namespace musclewarp
