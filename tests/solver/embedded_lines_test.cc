// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/embedded_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// Mean value coordinates reproduce linear functions up to rounding; mm, of
// coordinates of size 100.
constexpr double kLineRounding = 1e-11;

// Three lines inside the hull, of different lengths; the second has no point.
std::vector<Points> Lines() {
  std::vector<Points> lines(3);
  lines[0].resize(3, 3);
  lines[0] << 0, 0, -40, 1, 2, 0, 0, 0, 45;
  lines[1].resize(0, 3);
  lines[2].resize(2, 3);
  lines[2] << 5, -3, -20, 4, -3, 30;
  return lines;
}

double Distance(const Points& a, const Points& b) {
  return a.rows() == 0 ? 0 : (a - b).rowwise().norm().maxCoeff();
}

}  // namespace

TEST(EmbeddedLines, AreWhereTheyWereInTheRestPose) {
  const TriangleSoup hull = Spindle(15, 66, 2);
  const EmbeddedLines carried =
      EmbedLines(Lines(), hull.points, hull.triangles);
  ASSERT_EQ(carried.num_lines(), 3);
  const std::vector<Points> rest = LinesAt(carried, hull.points);
  ASSERT_EQ(rest.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(rest[k].rows(), Lines()[k].rows());
    EXPECT_LT(Distance(rest[k], Lines()[k]), kLineRounding);
  }
}

TEST(EmbeddedLines, FollowEveryAffineMotionOfTheHull) {
  const TriangleSoup hull = Spindle(15, 66, 2);
  const EmbeddedLines carried =
      EmbedLines(Lines(), hull.points, hull.triangles);
  Eigen::Matrix3d linear =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  linear(0, 1) += 0.3;  // a shear
  const Eigen::RowVector3d shift(10, -20, 30);
  const auto moved = [&](const Points& points) -> Points {
    return (points * linear.transpose()).rowwise() + shift;
  };
  const std::vector<Points> lines = LinesAt(carried, moved(hull.points));
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(Distance(lines[k], moved(Lines()[k])), kLineRounding);
  }
}

TEST(EmbeddedLines, MoveAsTheFineVerticesDo) {
  // Points of a line that are vertices of the fine mesh stay on them, whatever
  // the hull does.
  const TriangleSoup hull = Spindle(15, 66, 2);
  const Points fine = Spindle(12, 60, 2).points;
  const EmbeddedLines carried =
      EmbedLines({fine.topRows(4)}, hull.points, hull.triangles);
  Points bent = hull.points;
  bent.col(0) += 0.02 * hull.points.col(2).cwiseAbs2();
  const Points moved =
      MeanValueCoordinates(fine, hull.points, hull.triangles) * bent;
  EXPECT_LT(Distance(LinesAt(carried, bent)[0], moved.topRows(4)),
            kLineRounding);
  EXPECT_GT(Distance(moved.topRows(4), fine.topRows(4)), 1);
}

TEST(EmbeddedLines, MayBeNone) {
  const TriangleSoup hull = Spindle(15, 66, 1);
  const EmbeddedLines none = EmbedLines({}, hull.points, hull.triangles);
  EXPECT_EQ(none.num_lines(), 0);
  EXPECT_TRUE(LinesAt(none, hull.points).empty());
}

}  // namespace musclewarp
