// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scale_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ScaleWarnings, NameBothMeshesOfAPairBeyondTheRatio) {
  const std::vector<MeshSize> sizes = {
      {"femur", 450}, {"toe", 12}, {"psoas", 0.4}};
  EXPECT_THAT(
      ScaleWarnings(sizes, 100),
      ElementsAre(AllOf(HasSubstr("femur is 450 mm"), HasSubstr("psoas"))));
  EXPECT_THAT(ScaleWarnings(sizes, 2000), IsEmpty());
  EXPECT_THAT(ScaleWarnings({}, 1), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
