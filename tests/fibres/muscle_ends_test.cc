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

// How far the upper tip is away from the area by the pelvis, as a share of the
// length; 0 without an area.
double ShareBeyond(const TriangleSoup& muscle, const BallBones& bones) {
  const auto near = VerticesNearBones(muscle.points, bones.bodies());
  double highest = -50;
  for (const int v : near[0]) highest = std::max(highest, muscle.points(v, 2));
  return near[0].empty() ? 0 : (50 - highest) / 100;
}

// A tip that is farther from all areas than three tenths of the length has lost
// its bone. Places are known to a voxel, which is 1.9 mm, at both ends.
TEST_F(MuscleEndsTest, ATipIsLoneBeyondThreeTenthsOfTheLength) {
  const auto height_of_origin = [&](double share) {
    double z = 40;
    do {
      bones_ = BallBones();
      bones_.Add("pelvis", {18, 0, z -= 0.5});
    } while (ShareBeyond(muscle_, bones_) < share);
    bones_.Add("femur", {0, 0, -56});
    return MeanHeight(Find().origin);
  };
  EXPECT_LT(height_of_origin(0.26), 25);
  EXPECT_GT(height_of_origin(0.34), 30);
}

// Where a line ends at the tip, a tenth is enough.
TEST_F(MuscleEndsTest, ATipWithALineIsLoneBeyondATenthOfTheLength) {
  ActionLine line;
  line.name = "line";
  line.rest.resize(2, 3);
  line.rest << 0, 0, -50, 0, 0, 49;
  line.bodies = {"femur", "vertebra"};
  const auto body_above = [&](double share) {
    double z = 56;
    do {
      bones_ = BallBones();
      bones_.Add("pelvis", {16, 0, z -= 0.5});
    } while (ShareBeyond(muscle_, bones_) < share);
    bones_.Add("femur", {0, 0, -56});
    const MuscleEnds ends = Find({}, {line});
    return MeanHeight(ends.origin) > 0 ? ends.origin.body : ends.insertion.body;
  };
  EXPECT_EQ(body_above(0.06), "pelvis");
  EXPECT_EQ(body_above(0.14), "vertebra");
}

// Points at heights above a plate, by distance.
TEST(VerticesNearBones, AreNoFartherThanThreeMillimetresFromTheNearest) {
  const TriangleSoup plate = MovedBy(Box(50, 50, 2), {0, 0, -1});
  const TriangleBvh tree(plate.points, plate.triangles);
  const std::vector<BodySurface> bodies = {{"pelvis", {&tree}}};
  EXPECT_EQ(bodies[0].Distance({0, 0, 4}), 4);
  const auto near = [&](const std::vector<double>& heights) {
    Points points = Points::Zero(static_cast<Eigen::Index>(heights.size()), 3);
    for (size_t i = 0; i < heights.size(); ++i) points(i, 2) = heights[i];
    return VerticesNearBones(points, bodies)[0];
  };
  EXPECT_EQ(near({4.1, 1, 3.9}), (std::vector<int>{1, 2}));
  EXPECT_EQ(near({12.8, 9.9, 13.1}), (std::vector<int>{0, 1}));
  EXPECT_TRUE(near({10.1, 11}).empty());
  EXPECT_TRUE(near({}).empty());
}

TEST(VerticesNearBones, AreOfTheNearestBodyOnly) {
  const TriangleSoup low = MovedBy(Box(50, 50, 2), {0, 0, -1});
  const TriangleSoup high = MovedBy(Box(50, 50, 2), {0, 0, 5});
  const TriangleBvh low_tree(low.points, low.triangles);
  const TriangleBvh high_tree(high.points, high.triangles);
  Points points = Points::Zero(4, 3);
  points.col(2) << 0.5, 1.9, 2.1, 3.5;
  const auto near = VerticesNearBones(
      points, {{"pelvis", {&low_tree}}, {"femur", {&high_tree}}});
  EXPECT_EQ(near[0], (std::vector<int>{0, 1}));
  EXPECT_EQ(near[1], (std::vector<int>{2, 3}));
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
