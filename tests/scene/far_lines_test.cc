// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/far_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A mesh of two vertices 10 mm apart, on the z axis.
Points TwoVertices() {
  Points points = Points::Zero(2, 3);
  points(1, 2) = 10;
  return points;
}

// A muscle with a line from the origin to `end`, and one that stays inside.
SceneMuscle MuscleWithLineTo(const Eigen::RowVector3d& end) {
  SceneMuscle muscle;
  muscle.name = "soleus";
  for (const char* name : {"long", "short"}) {
    ActionLine line;
    line.name = name;
    line.rest = TwoVertices();
    muscle.lines.push_back(line);
  }
  muscle.lines[0].rest.row(1) = end;
  return muscle;
}

TEST(FarLineWarnings, AreGivenBeyondFiveDiagonalsOnly) {
  EXPECT_THAT(FarLineWarnings(MuscleWithLineTo({0, 0, 60}), TwoVertices()),
              IsEmpty());
  EXPECT_THAT(FarLineWarnings(MuscleWithLineTo({0, 0, 61}), TwoVertices()),
              ElementsAre(AllOf(HasSubstr("point 1 of line long"),
                                HasSubstr("51 mm"),
                                HasSubstr("soleus"),
                                HasSubstr("10 mm across"))));
}

TEST(FarLineWarnings, NameTheFarthestPointOfALine) {
  SceneMuscle muscle = MuscleWithLineTo({0, 0, 61});
  Points& rest = muscle.lines[0].rest;
  rest.conservativeResize(4, 3);
  rest.row(2) << 0, 0, 1e6;
  rest.row(3) << 0, 0, 100;
  EXPECT_THAT(FarLineWarnings(muscle, TwoVertices()),
              ElementsAre(HasSubstr("point 2 of line long")));
}

}  // namespace
}  // namespace musclewarp
