// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/line_ends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/preparation/surroundings.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

ActionLine UprightLine(double from, double to) {
  ActionLine line;
  line.rest.resize(2, 3);
  line.rest << 0, 0, from, 0, 0, to;
  line.bodies = {"low", "high"};
  return line;
}

// Balls of 10 mm with a pole at (0, 0, 0) and at (0, 0, 100).
TEST(LineEndsOf, AreTheMeanDistancesFromTheBones) {
  Surroundings bones;
  bones.AddBone("low", "low", SphereAt({0, 0, -10}, 10, 3));
  bones.AddBone("high", "high", SphereAt({0, 0, 110}, 10, 3));
  const std::vector<LineEnd> ends =
      LineEndsOf({UprightLine(2, 90), UprightLine(4, 70)}, bones.bodies());
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].body, "low");
  EXPECT_NEAR(ends[0].distance, 3, 1e-9);  // the pole is a vertex
  EXPECT_EQ(ends[1].body, "high");
  EXPECT_NEAR(ends[1].distance, 20, 1e-9);
  EXPECT_THAT(FarEndWarnings("soleus", ends, 1),
              ElementsAre(AllOf(HasSubstr("soleus ends 20 mm away from high"),
                                HasSubstr("end_bodies"))));
  EXPECT_THAT(FarEndWarnings("soleus", ends, 1.0 / 32),
              ElementsAre(HasSubstr("soleus ends 0.625 mm away from high, to "
                                    "which its lines are fixed, expected at "
                                    "most 0.469 mm")));
}

TEST(FarEndWarnings, SayOnceWhatIsTrueOfBothEnds) {
  EXPECT_THAT(
      FarEndWarnings("soleus", {{"tibia", 20}, {"tibia", 20.001}}, 1),
      ElementsAre(HasSubstr("both ends of soleus are 20 mm away from tibia")));
  EXPECT_THAT(FarEndWarnings("soleus", {{"tibia", 20}, {"calcn", 20}}, 1),
              SizeIs(2));
}

TEST(LineEndsOf, LeaveOutBodiesWithoutBones) {
  Surroundings bones;
  bones.AddBone("low", "low", SphereAt({0, 0, -10}, 10, 3));
  EXPECT_EQ(LineEndsOf({UprightLine(2, 90)}, bones.bodies()).size(), 1u);
}

}  // namespace
}  // namespace musclewarp
