// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/found_supports.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/skeleton/polyline.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRounding = 1e-9;  // of coordinates of some 100 mm

// A line in the plane y = 0 over a bone, a ball of radius 30 around the origin:
// a quarter of a circle around the ball, straight before and beyond.
class FoundSupports : public testing::Test {
 protected:
  static constexpr double kRadius = 30;

  FoundSupports() : bone_(SphereAt({0, 0, 0}, kRadius, 4)) { MakeLines(1); }

  // Lines at `height` mm above the bone, beside each other.
  void MakeLines(int count, double height = 3) {
    const double radius = kRadius + height;
    lines_.clear();
    for (int k = 0; k < count; ++k) {
      ActionLine& line = lines_.emplace_back();
      line.name = "line_" + std::to_string(k + 1);
      line.rest.resize(19, 3);
      for (int i = 0; i < 19; ++i) {
        const double along = 10 * (i - 9);
        const double on_arc =
            std::min(std::max(along, -radius * kPi / 4), radius * kPi / 4);
        const double angle = on_arc / radius, beyond = along - on_arc;
        line.rest.row(i) << radius * std::sin(angle) + beyond * std::cos(angle),
            12.0 * k, radius * std::cos(angle) - beyond * std::sin(angle);
        line.bodies.push_back(i < 18 ? "upper" : "lower");
      }
      line.slides = true;
    }
  }

  LineSurroundings Around() const {
    LineSurroundings around;
    around.bodies = {{"upper", {&bone_tree_}}, {"lower", {}}};
    return around;
  }

  TriangleSoup bone_;
  TriangleBvh bone_tree_{bone_.points, bone_.triangles};
  std::vector<ActionLine> lines_;
};

TEST_F(FoundSupports, BearTheBendsOfTheLine) {
  FindSupports(Around(), &lines_);
  const Points& rest = lines_[0].rest;
  const LineSupports& supports = *lines_[0].supports;
  for (Eigen::Index i = 1; i + 1 < rest.rows(); ++i) {
    const Eigen::RowVector3d pull =
        (rest.row(i + 1) - rest.row(i)).normalized() -
        (rest.row(i) - rest.row(i - 1)).normalized();
    EXPECT_LT((supports.loads[i] * supports.bends.row(i) - pull).norm(),
              kRounding)
        << i;
    EXPECT_EQ(supports.stiffness[i] > 0, supports.loads[i] > 0) << i;
  }
}

TEST_F(FoundSupports, AreHardOverABoneThatIsTouched) {
  FindSupports(Around(), &lines_);
  EXPECT_GT(lines_[0].supports->stiffness[9], 9);  // of 10 / mm
  // 12 mm above the bone something else holds the line, which yields: its
  // push doubles over 5 mm.
  MakeLines(1, 12);
  FindSupports(Around(), &lines_);
  const LineSupports& supports = *lines_[0].supports;
  EXPECT_DOUBLE_EQ(supports.stiffness[9], supports.loads[9] / 5);
}

TEST_F(FoundSupports, AreHardWhereATendonWithoutAMeshTouchesTheBone) {
  // Far from its muscle, which says nothing of the tendon's thickness.
  const TriangleSoup far = SphereAt({0, 0, -300}, 10, 3);
  const TriangleBvh muscle(far.points, far.triangles);
  LineSurroundings around = Around();
  around.soft = {&muscle};
  lines_[0].bare_end = PolylineLength(lines_[0].rest);
  FindSupports(around, &lines_);
  EXPECT_GT(lines_[0].supports->stiffness[9], 9);  // of 10 / mm
  // 15 mm above the bone nothing touches it.
  MakeLines(1, 15);
  lines_[0].bare_end = PolylineLength(lines_[0].rest);
  FindSupports(around, &lines_);
  const LineSupports& supports = *lines_[0].supports;
  EXPECT_DOUBLE_EQ(supports.stiffness[9], supports.loads[9] / 5);
}

TEST_F(FoundSupports, YieldWhereTheLineBendsAwayFromTheBone) {
  // Below the ball the same line bends away from it.
  for (ActionLine& line : lines_) line.rest.col(2).array() -= 2 * kRadius + 6;
  FindSupports(Around(), &lines_);
  const LineSupports& supports = *lines_[0].supports;
  EXPECT_GT(supports.loads[9], 0.1);
  EXPECT_DOUBLE_EQ(supports.stiffness[9], supports.loads[9] / 5);
  EXPECT_GT(supports.plane_stiffness[9], 9);
  EXPECT_LT(supports.outward(9, 2), -0.99);
}

TEST_F(FoundSupports, HoldTheLineUpToTheMiddleOfItsAttachment) {
  LineSurroundings around = Around();
  SoftPartEnd end;
  end.body = "upper";
  end.points = lines_[0].rest.topRows(7);  // their middle is point 3
  around.ends = {end};
  FindSupports(around, &lines_);
  const Eigen::VectorXd& hold = lines_[0].supports->hold;
  EXPECT_DOUBLE_EQ(hold[1], hold[3]);
  EXPECT_GT(hold[3], hold[4]);
  EXPECT_EQ(hold[5], 0);  // 20 mm on
}

TEST_F(FoundSupports, DoNotDependOnWhereTheBodyIs) {
  LineSurroundings around = Around();
  FindSupports(around, &lines_);
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  motion.topRightCorner<3, 1>() << 300, -20, 1000;
  std::vector<ActionLine> moved = lines_;
  const Points bone = Transformed(bone_.points, motion);
  const TriangleBvh tree(bone, bone_.triangles);
  around.bodies[0].bones = {&tree};
  for (ActionLine& line : moved) line.rest = Transformed(line.rest, motion);
  FindSupports(around, &moved);
  const LineSupports &a = *lines_[0].supports, &b = *moved[0].supports;
  const Eigen::Matrix3d turn = motion.topLeftCorner<3, 3>();
  EXPECT_LT((b.bends - a.bends * turn.transpose()).norm(), 1e-6);
  EXPECT_LT((b.outward - a.outward * turn.transpose()).norm(), 1e-6);
  EXPECT_LT((b.stiffness - a.stiffness).norm(), 1e-6);
  EXPECT_LT((b.plane_stiffness - a.plane_stiffness).norm(), 1e-6);
  EXPECT_LT((b.hold - a.hold).norm(), 1e-6);
}

TEST_F(FoundSupports, TieLinesOfOneMuscleThatRunAlike) {
  MakeLines(3);
  FindSupports(Around(), &lines_);
  const auto& ties = lines_[0].supports->ties;
  ASSERT_EQ(ties.size(), 2u);
  EXPECT_EQ(ties[0].other, 1);
  EXPECT_EQ(ties[1].other, 2);
  // 2 / 3 of 10 mm / (12 mm)^2, and a quarter of it for twice the distance.
  EXPECT_NEAR(ties[0].stiffness[9], 2.0 / 3 * 10 / 144, 1e-3);
  EXPECT_NEAR(ties[1].stiffness[9], ties[0].stiffness[9] / 4, 1e-6);

  // A line that runs the other way, or has other points, stays on its own.
  MakeLines(3);
  lines_[1].rest = Points(lines_[1].rest.colwise().reverse());
  lines_[2].rest.conservativeResize(18, 3);
  lines_[2].bodies.resize(18, "upper");
  FindSupports(Around(), &lines_);
  for (const ActionLine& line : lines_) {
    EXPECT_TRUE(line.supports->ties.empty());
  }
}

TEST_F(FoundSupports, AreNotSoughtForLinesThatDoNotSlide) {
  lines_[0].slides = false;
  FindSupports(Around(), &lines_);
  EXPECT_FALSE(lines_[0].supports);
}

}  // namespace
}  // namespace musclewarp
