// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/muscle_ends.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fibres/ball_bones.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A spindle along z from -50 to 50 and balls of bone at heights along it.
class MuscleEndsTest : public ::testing::Test {
 protected:
  MuscleEnds Find(const std::vector<Attachment>& attachments = {},
                  const std::vector<ActionLine>& lines = {},
                  EndExtent extent = EndExtent::kFarPart) const {
    return FindMuscleEnds(
        muscle_, grid_, bones_.bodies(), {attachments, lines}, extent);
  }

  double MeanHeight(const MuscleEnd& end) const {
    double sum = 0;
    for (const int v : end.voxels) sum += grid_.Center(v)[2];
    return sum / static_cast<double>(end.voxels.size());
  }

  const TriangleSoup muscle_ = Spindle(10, 50, 3);
  const VoxelGrid grid_ = Voxelize(muscle_, 3000);
  BallBones bones_;
};

TEST_F(MuscleEndsTest, AreWhereItLiesNearItsBones) {
  bones_.Add("pelvis", {0, 0, 56});
  bones_.Add("femur", {0, 0, -56});
  const MuscleEnds ends = Find();
  EXPECT_EQ(ends.origin.body, "pelvis");
  EXPECT_EQ(ends.insertion.body, "femur");
  EXPECT_GT(MeanHeight(ends.origin), 35);
  EXPECT_LT(MeanHeight(ends.insertion), -35);
}

TEST_F(MuscleEndsTest, OfThreeBonesTheOuterTwoCount) {
  bones_.Add("pelvis", {0, 0, 56});
  bones_.Add("femur", {18, 0, 0});
  bones_.Add("tibia", {0, 0, -56});
  const MuscleEnds ends = Find();
  EXPECT_EQ(ends.origin.body, "pelvis");
  EXPECT_EQ(ends.insertion.body, "tibia");
}

TEST_F(MuscleEndsTest, AnEndWithoutBoneGoesToTheNearestBody) {
  bones_.Add("pelvis", {18, 0, 10});
  bones_.Add("femur", {0, 0, -56});
  const MuscleEnds ends = Find();
  EXPECT_EQ(ends.origin.body, "pelvis");
  // Not where the pelvis touches, but at the tip beyond.
  EXPECT_GT(MeanHeight(ends.origin), 30);
  EXPECT_LT(MeanHeight(ends.insertion), -35);
}

TEST_F(MuscleEndsTest, ATipWhereALineEndsIsAnEnd) {
  // The pelvis touches a quarter of the length below the tip.
  bones_.Add("pelvis", {16, 0, 26});
  bones_.Add("femur", {0, 0, -56});
  EXPECT_NEAR(MeanHeight(Find().origin), 26, 5);
  ActionLine line;
  line.name = "line";
  line.rest.resize(2, 3);
  line.rest << 0, 0, -50, 0, 0, 49;
  line.bodies = {"femur", "vertebra"};
  const MuscleEnds ends = Find({}, {line});
  EXPECT_EQ(ends.insertion.body, "vertebra");
  EXPECT_GT(MeanHeight(ends.insertion), 38);
  EXPECT_EQ(ends.origin.body, "femur");
}

TEST_F(MuscleEndsTest, OneBoneOrNoneIsEnough) {
  MuscleEnds ends = Find();
  EXPECT_EQ(ends.origin.body, "");
  EXPECT_GT(std::abs(MeanHeight(ends.origin) - MeanHeight(ends.insertion)), 60);
  bones_.Add("pelvis", {0, 0, 56});
  ends = Find();
  EXPECT_EQ(ends.origin.body, "pelvis");
  EXPECT_EQ(ends.insertion.body, "pelvis");
  EXPECT_GT(std::abs(MeanHeight(ends.origin) - MeanHeight(ends.insertion)), 60);
}

TEST_F(MuscleEndsTest, AttachmentsInOnePlaceLeaveTheTips) {
  Attachment a;
  a.body = "pelvis";
  a.points = Eigen::RowVector3d(0, 10, 0);
  a.radius = 6;
  Attachment b = a;
  b.body = "femur";
  const MuscleEnds ends = Find({a, b});
  EXPECT_GT(std::abs(MeanHeight(ends.origin) - MeanHeight(ends.insertion)), 80);
}

TEST_F(MuscleEndsTest, AttachmentsComeFirst) {
  bones_.Add("pelvis", {0, 0, 56});
  bones_.Add("femur", {0, 0, -56});
  Attachment a, b;
  a.body = "femur";
  a.points = Eigen::RowVector3d(0, 10, 0);
  a.radius = 6;
  b.body = "pelvis";
  b.points = Eigen::RowVector3d(0, 0, 50);
  b.radius = 6;
  const MuscleEnds ends = Find({a, b});
  EXPECT_EQ(ends.origin.body, "pelvis");
  EXPECT_GT(MeanHeight(ends.origin), 40);
  EXPECT_EQ(ends.insertion.body, "femur");
  EXPECT_NEAR(MeanHeight(ends.insertion), 0, 5);
}

// Given areas are not cut, however near they come to the other end, and those
// of one body count together.
TEST_F(MuscleEndsTest, GivenAreasCountWhole) {
  Attachment low, high, insertion;
  low.body = high.body = "pelvis";
  low.points = Eigen::RowVector3d(0, 10, 0);
  high.points = Eigen::RowVector3d(0, 0, 50);
  insertion.body = "femur";
  insertion.points = Eigen::RowVector3d(0, 0, -50);
  low.radius = high.radius = insertion.radius = 8;
  bones_.Add("pelvis", {0, 0, 90});
  bones_.Add("femur", {0, 0, -90});
  const MuscleEnds ends = Find({low, high, insertion});
  double lowest = 50, highest = -50;
  for (const int v : ends.origin.voxels) {
    lowest = std::min(lowest, grid_.Center(v)[2]);
    highest = std::max(highest, grid_.Center(v)[2]);
  }
  EXPECT_LT(lowest, -3);
  EXPECT_GT(highest, 43);
  EXPECT_LT(MeanHeight(ends.insertion), -43);
}

// Fibres of an origin that runs along the muscle begin where it is clear of the
// bones of the insertion; the far part of it alone begins at a height of 13 mm.
TEST_F(MuscleEndsTest, AnOriginAlongTheMuscleIsClearOfTheOtherBone) {
  for (const double z : {-36, 2, 14, 26, 38}) bones_.Add("pelvis", {16, 0, z});
  bones_.Add("femur", {0, 0, -56});
  const auto lowest = [&](EndExtent extent) {
    const MuscleEnds ends = Find({}, {}, extent);
    EXPECT_LT(MeanHeight(ends.insertion), -35);
    double least = 50;
    for (const int v : ends.origin.voxels) {
      least = std::min(least, grid_.Center(v)[2]);
    }
    return least;
  };
  EXPECT_LT(lowest(EndExtent::kClearOfOther), 5);
  // The bones reach down to -44.
  EXPECT_GT(lowest(EndExtent::kClearOfOther), -32);
  EXPECT_GT(lowest(EndExtent::kFarPart), 5);
}

TEST_F(MuscleEndsTest, PointsNearBonesAreThoseOfTheNearestBody) {
  bones_.Add("pelvis", {0, 0, 56});
  bones_.Add("femur", {0, 0, -56});
  const auto near = VerticesNearBones(muscle_.points, bones_.bodies());
  ASSERT_EQ(near.size(), 2u);
  for (const size_t b : {0, 1}) {
    ASSERT_FALSE(near[b].empty());
    for (const int v : near[b]) {
      EXPECT_GT((b == 0 ? 1 : -1) * muscle_.points(v, 2), 40);
    }
  }
}

}  // namespace
}  // namespace musclewarp
