// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/initial_fix.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_contact/lone_body.h"

namespace musclewarp {
namespace {

PaperContactOptions FixOptions() {
  PaperContactOptions options;
  options.clearance = 0.001;
  // The boxes are small, and their regions further apart than a tenth.
  options.pairing_fraction = 0.3;
  return options;
}

// Shares the layer 3.5 < z < 4 with the lower box: the upper side of that one
// and the lower side of this one are inside, but for their rims.
TriangleSoup BoxInside() { return UpperBox(3.5); }

Eigen::RowVector3d MeanOf(const std::vector<int>& vertices,
                          const LoneBody& body) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const int v : vertices) sum += body.shape.rest.row(v);
  return sum / static_cast<double>(vertices.size());
}

struct Moves {
  explicit Moves(const LoneBody& body)
      : all(body.body.points() - body.shape.rest) {
    for (Eigen::Index v = 0; v < all.rows(); ++v) {
      if (!all.row(v).isZero(0)) vertices.push_back(static_cast<int>(v));
    }
  }
  Points all;
  std::vector<int> vertices;
};

}  // namespace

TEST(InitialFix, LeavesWhatIsApart) {
  LoneBody a(LowerBox(), true);
  LoneBody b(MovedBy(BoxInside(), {0, 0, 1}), true);
  EXPECT_FALSE(FixInitialIntersections(FixOptions(), &a.body, &b.body));
  EXPECT_EQ(a.body.points(), a.shape.rest);
  EXPECT_EQ(b.body.points(), b.shape.rest);
}

TEST(InitialFix, PairedAgainstAnObstacleGoesAllTheWayInParallel) {
  LoneBody muscle(LowerBox(), true);
  LoneBody bone(BoxInside(), false);
  const std::vector<int> inside = bone.body.Inside(muscle.shape.rest);
  ASSERT_GT(inside.size(), 10u);
  const Eigen::RowVector3d way =
      MeanOf(muscle.body.Inside(bone.shape.rest), bone) -
      MeanOf(inside, muscle);
  EXPECT_TRUE(FixInitialIntersections(FixOptions(), &muscle.body, &bone.body));
  const Moves moves(muscle);
  EXPECT_EQ(moves.vertices, inside);
  const Eigen::RowVector3d direction = moves.all.row(inside[0]).normalized();
  // From its centre to that of the bone's region, which is out.
  EXPECT_LT(direction.z(), 0);
  EXPECT_LT((direction - way.normalized()).norm(), kCoordinateRounding);
  for (const int v : inside) {
    EXPECT_NEAR(
        moves.all.row(v).normalized().dot(direction), 1, kCoordinateRounding);
    // The bone's lower side is at 3.5, the clearance beyond along the
    // direction.
    EXPECT_NEAR(muscle.body.points()(v, 2),
                3.5 + 0.001 * direction.z(),
                kCoordinateRounding);
  }
  EXPECT_EQ(bone.body.points(), bone.shape.rest);
  EXPECT_TRUE(bone.body.Inside(muscle.body.points()).empty());
}

TEST(InitialFix, PairedMusclesGiveWayBySixTenthsEach) {
  LoneBody a(LowerBox(), true);
  LoneBody b(BoxInside(), true);
  const std::vector<int> inside_a = b.body.Inside(a.shape.rest);
  const std::vector<int> inside_b = a.body.Inside(b.shape.rest);
  EXPECT_TRUE(FixInitialIntersections(FixOptions(), &a.body, &b.body));
  const Moves moves_a(a);
  const Moves moves_b(b);
  EXPECT_EQ(moves_a.vertices, inside_a);
  EXPECT_EQ(moves_b.vertices, inside_b);
  const Eigen::RowVector3d direction =
      moves_a.all.row(inside_a[0]).normalized();
  // The way to the other side is 0.5 along z.
  const double move = 0.6 * 0.5 - 0.001 * direction.z();
  for (const int v : inside_a) {
    EXPECT_NEAR(moves_a.all(v, 2), -move, kCoordinateRounding);
  }
  for (const int v : inside_b) {
    EXPECT_NEAR(moves_b.all.row(v).normalized().dot(direction),
                -1,
                kCoordinateRounding);
    EXPECT_NEAR(moves_b.all(v, 2), move, kCoordinateRounding);
  }
}

// A pyramid whose tip comes through the middle of a large triangle, paper fig.
// 3.1: no vertex of the other is inside.
class UnpairedTip : public ::testing::Test {
 protected:
  static TriangleSoup Pyramid() {
    TriangleSoup soup;
    soup.points.resize(5, 3);
    soup.points << -1, -1, -3, 1, -1, -3, 1, 1, -3, -1, 1, -3, 0.3, 0.2, 0.5;
    soup.triangles.resize(6, 3);
    soup.triangles << 0, 2, 1, 0, 3, 2, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
    return soup;
  }
  static TriangleSoup Slab() {
    return MovedBy(LatticeBox(1, 1, 1), {-0.5, -0.5, 0});
  }
};

TEST_F(UnpairedTip, GoesAgainstItsNormalAllTheWay) {
  for (const bool other_gives_way : {false, true}) {
    LoneBody pyramid(Pyramid(), true);
    TriangleSoup large = Slab();
    large.points.leftCols(2) *= 20;
    LoneBody slab(large, other_gives_way);
    ASSERT_EQ(slab.body.Inside(pyramid.shape.rest), std::vector<int>{4});
    EXPECT_TRUE(
        FixInitialIntersections(FixOptions(), &pyramid.body, &slab.body));
    const Moves moves(pyramid);
    EXPECT_EQ(moves.vertices, std::vector<int>{4});
    // The tip's normal is up, leaning as the tip does; the way is 0.5 along z.
    EXPECT_NEAR(pyramid.body.points()(4, 2),
                0.001 * moves.all.row(4).normalized().z(),
                kCoordinateRounding);
    EXPECT_EQ(slab.body.points(), slab.shape.rest);
  }
}

TEST_F(UnpairedTip, OfAnObstacleIsLeft) {
  TriangleSoup large = Slab();
  large.points.leftCols(2) *= 20;
  LoneBody slab(large, true);
  LoneBody pyramid(Pyramid(), false);
  EXPECT_TRUE(FixInitialIntersections(FixOptions(), &slab.body, &pyramid.body));
  EXPECT_EQ(slab.body.points(), slab.shape.rest);
  EXPECT_EQ(pyramid.body.points(), pyramid.shape.rest);
}

TEST(InitialFix, WhichRegionsArePairedGoesByTheSmallerBody) {
  // The regions' centres are 1.2 apart, which is between a fifth and three
  // tenths of the radius of a box of 6 x 6 x 4. That a column on the same base
  // has a larger radius makes no difference.
  for (const double share : {0.2, 0.3}) {
    PaperContactOptions options = FixOptions();
    options.pairing_fraction = share;
    for (const bool is_muscle : {true, false}) {
      LoneBody a(LowerBox(), true), b(LowerBox(), true);
      LoneBody box(BoxInside(), is_muscle);
      LoneBody column(MovedBy(LatticeBox(6, 6, 40), {0.25, 0.25, 3.5}),
                      is_muscle);
      EXPECT_TRUE(FixInitialIntersections(options, &a.body, &box.body));
      EXPECT_TRUE(FixInitialIntersections(options, &b.body, &column.body));
      EXPECT_LT((a.body.points() - b.body.points()).cwiseAbs().maxCoeff(),
                kCoordinateRounding)
          << share;
    }
  }
}

TEST(InitialFix, RegionsTooFarApartAreNotPaired) {
  PaperContactOptions options = FixOptions();
  options.pairing_fraction = 0;
  LoneBody muscle(LowerBox(), true);
  LoneBody bone(BoxInside(), false);
  EXPECT_TRUE(FixInitialIntersections(options, &muscle.body, &bone.body));
  // Against the mean normal instead, which is along z but for the rim.
  const Moves moves(muscle);
  for (const int v : moves.vertices) {
    EXPECT_NEAR(muscle.body.points()(v, 2), 3.5, 0.0011);
  }
  EXPECT_TRUE(bone.body.Inside(muscle.body.points()).empty());
}

}  // namespace musclewarp
