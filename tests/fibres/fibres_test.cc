// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/fibres.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fibres/ball_bones.h"
#include "fibres/tendon_muscle.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/proximity/inside_test.h"
#include "musclewarp/skeleton/polyline.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// A bent spindle between two balls of bone.
class FibresTest : public ::testing::Test {
 protected:
  FibresTest() : muscle_(Spindle(10, 50, 3)) {
    for (Eigen::Index i = 0; i < muscle_.points.rows(); ++i) {
      muscle_.points(i, 0) +=
          0.006 * muscle_.points(i, 2) * muscle_.points(i, 2);
    }
    bones_.Add("pelvis", {15, 0, 56});
    bones_.Add("femur", {15, 0, -56});
  }
  TriangleSoup muscle_;
  BallBones bones_;
};

TEST_F(FibresTest, RunInsideFromOriginToInsertion) {
  FibreOptions options;
  options.fibres = 60;
  const auto fibres = MakeFibres(muscle_, bones_.bodies(), {}, options);
  ASSERT_EQ(fibres.size(), 60u);
  const InsideTest inside(muscle_.points, muscle_.triangles, 3);
  for (const Points& fibre : fibres) {
    ASSERT_EQ(fibre.rows(), options.segments + 1);
    for (Eigen::Index i = 0; i < fibre.rows(); ++i) {
      EXPECT_TRUE(inside.Contains(fibre.row(i)));
    }
    EXPECT_GT(fibre(0, 2), 35);
    EXPECT_LT(fibre(fibre.rows() - 1, 2), -35);
    // The muscle is 107 mm long along its bend; both ends lie in the areas.
    EXPECT_GT(PolylineLength(fibre), 75);
    EXPECT_LT(PolylineLength(fibre), 115);
  }
}

TEST_F(FibresTest, SegmentsOfAFibreAreAlike) {
  FibreOptions options;
  options.fibres = 10;
  for (const Points& fibre :
       MakeFibres(muscle_, bones_.bodies(), {}, options)) {
    const double mean = PolylineLength(fibre) / options.segments;
    for (Eigen::Index i = 0; i + 1 < fibre.rows(); ++i) {
      // Points outside are pulled in by a part of a voxel.
      EXPECT_NEAR((fibre.row(i + 1) - fibre.row(i)).norm(), mean, 0.3 * mean);
    }
  }
}

TEST_F(FibresTest, TheSameEveryTime) {
  FibreOptions options;
  options.fibres = 20;
  const auto a = MakeFibres(muscle_, bones_.bodies(), {}, options);
  const auto b = MakeFibres(muscle_, bones_.bodies(), {}, options);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i], b[i]);
}

TEST_F(FibresTest, LinesFollowTheBonesTheyAreNearestTo) {
  const auto lines =
      MakeLines("m", muscle_, bones_.bodies(), {}, 3, LinePoints::kNine);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].name, "m_1");
  EXPECT_EQ(lines[2].name, "m_3");
  for (const ActionLine& line : lines) {
    ASSERT_EQ(line.rest.rows(), 9);
    EXPECT_TRUE(line.slides);
    EXPECT_EQ(line.bodies.front(), "pelvis");
    EXPECT_EQ(line.bodies[3], "pelvis");
    EXPECT_EQ(line.bodies[5], "femur");
    EXPECT_EQ(line.bodies.back(), "femur");
  }
}

TEST_F(FibresTest, OneLineIsTheCentreLine) {
  const auto lines =
      MakeLines("m", muscle_, bones_.bodies(), {}, 1, LinePoints::kNine);
  ASSERT_EQ(lines.size(), 1u);
  const Eigen::RowVector3d middle = lines[0].rest.row(4);
  // In the middle of the section at z = 0, whose radius is 10.
  EXPECT_LT((middle - Eigen::RowVector3d(0, 0, middle[2])).norm(), 2);
}

TEST_F(FibresTest, LinesReachTheTipsThroughATendon) {
  BallBones bones;
  bones.Add("pelvis", {0, 0, -72});
  bones.Add("femur", {0, 0, 72});
  const TriangleSoup muscle = MuscleWithTendon();
  const TriangleBvh surface(muscle.points, muscle.triangles);
  const InsideTest inside(muscle.points, muscle.triangles, 3);
  for (const ActionLine& line :
       MakeLines("m", muscle, bones.bodies(), {}, 3, LinePoints::kNine)) {
    // 95 % of the 120 mm of the muscle.
    EXPECT_LT(line.rest(0, 2), -57);
    EXPECT_GT(line.rest(8, 2), 57);
    EXPECT_EQ(line.bodies.front(), "pelvis");
    EXPECT_EQ(line.bodies.back(), "femur");
    for (Eigen::Index i = 0; i < line.rest.rows(); ++i) {
      const Eigen::RowVector3d point = line.rest.row(i);
      EXPECT_TRUE(inside.Contains(point) ||
                  surface.ClosestPoint(point).distance < 1e-9);
    }
  }
}

TEST_F(FibresTest, AMuscleOverThreeBodiesFollowsTheOneBetween) {
  bones_.Add("knee", {-20, 0, 0});
  const auto lines =
      MakeLines("m", muscle_, bones_.bodies(), {}, 1, LinePoints::kNine);
  EXPECT_THAT(lines[0].bodies,
              ElementsAre("pelvis",
                          "pelvis",
                          "pelvis",
                          "knee",
                          "knee",
                          "knee",
                          "femur",
                          "femur",
                          "femur"));
}

TEST_F(FibresTest, AFilmHasNoRoomForEither) {
  const TriangleSoup film = Box(80, 80, 0.001);
  EXPECT_TRUE(MakeFibres(film, bones_.bodies(), {}, FibreOptions()).empty());
  EXPECT_THROW(MakeLines("m", film, bones_.bodies(), {}, 1, LinePoints::kNine),
               InputError);
}

TEST_F(FibresTest, LinesNeedABone) {
  EXPECT_THROW(MakeLines("m", muscle_, {}, {}, 1, LinePoints::kNine),
               InputError);
}

}  // namespace
}  // namespace musclewarp
