// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/winding_number.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "proximity/random_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// The definition: the solid angles of all triangles (Van Oosterom and Strackee
// 1983) over 4 pi.
double BySolidAngles(const TriangleSoup& soup, const Eigen::RowVector3d& p) {
  double sum = 0;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const Eigen::RowVector3d a = soup.points.row(soup.triangles(f, 0)) - p;
    const Eigen::RowVector3d b = soup.points.row(soup.triangles(f, 1)) - p;
    const Eigen::RowVector3d c = soup.points.row(soup.triangles(f, 2)) - p;
    sum += 2 * std::atan2(a.dot(b.cross(c)),
                          a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                              b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * M_PI);
}

void ExpectTheDefinition(const TriangleSoup& soup) {
  const TriangleBvh bvh(soup.points, soup.triangles);
  const WindingNumber winding(&bvh, soup.triangles);
  // The definition sums a few hundred angles, of which those beside an edge
  // lose digits.
  constexpr double kSum = 1e-10;
  // Nearer to 1/2 than this, rounding may decide.
  constexpr double kUndecided = 1e-6;
  std::mt19937 engine(4);
  for (int i = 0; i < 2000; ++i) {
    Eigen::RowVector3d p;
    for (int k = 0; k < 3; ++k) p[k] = 30 * (engine() / 4294967296.0) - 15;
    const double expected = BySolidAngles(soup, p);
    EXPECT_NEAR(winding.At(p), expected, kSum);
    if (std::abs(expected - 0.5) > kUndecided) {
      EXPECT_EQ(winding.IsInside(p), expected > 0.5);
    }
  }
}

using Eigen::RowVector3d;

// A few hundred angles, each rounded to 1e-15.
constexpr double kAngleRounding = 1e-12;

// A mesh as the queries want it.
struct Solid {
  explicit Solid(const TriangleSoup& soup)
      : bvh(soup.points, soup.triangles), winding(&bvh, soup.triangles) {}
  Solid(const Solid&) = delete;
  TriangleBvh bvh;
  WindingNumber winding;
};

// The definition: solid angles of all triangles.
double AngleSum(const TriangleBvh& bvh, const RowVector3d& p) {
  double sum = 0;
  for (int f = 0; f < bvh.num_triangles(); ++f) {
    const RowVector3d a = bvh.corners(f).row(0) - p;
    const RowVector3d b = bvh.corners(f).row(1) - p;
    const RowVector3d c = bvh.corners(f).row(2) - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(
        a.dot(b.cross(c)),
        la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * M_PI);
}

void ExpectAngleSum(const TriangleSoup& soup, double size, int seed) {
  const Solid solid(soup);
  std::mt19937 random(seed);
  for (int i = 0; i < 300; ++i) {
    const RowVector3d p = RandomPoint(size, &random);
    EXPECT_NEAR(solid.winding.At(p), AngleSum(solid.bvh, p), kAngleRounding)
        << p;
  }
}

TriangleSoup WithoutTriangles(TriangleSoup soup, double share, int seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution is_dropped(share);
  int kept = 0;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    if (is_dropped(random)) continue;
    soup.triangles.row(kept++) = soup.triangles.row(f).eval();
  }
  soup.triangles.conservativeResize(kept, 3);
  return soup;
}

}  // namespace

TEST(WindingNumber, IsTheSumOfSolidAngles) {
  ExpectTheDefinition(Icosphere(10, 2));
  ExpectTheDefinition(Box(10, 12, 14));
}

TEST(WindingNumber, HasAnAnswerForOpenAndDirtyMeshes) {
  TriangleSoup soup = Icosphere(10, 2);
  soup.triangles.conservativeResize(soup.triangles.rows() - 40, 3);
  soup.triangles.row(3) = soup.triangles.row(4).eval();
  soup.triangles.col(0).head(9).swap(soup.triangles.col(1).head(9));
  ExpectTheDefinition(soup);
}

TEST(WindingNumber, RaysThroughCornersAndEdgesCountRight) {
  // Grid points line up with corners, edges and faces of the box.
  const TriangleSoup box = Box(4, 4, 4);
  const TriangleBvh bvh(box.points, box.triangles);
  const WindingNumber winding(&bvh, box.triangles);
  EXPECT_TRUE(winding.IsClosed());
  for (int i = 0; i < 343; ++i) {
    const Eigen::RowVector3i place(i % 7, i / 7 % 7, i / 49);
    const Eigen::RowVector3d p = place.cast<double>().array() - 3;
    const double reach = p.cwiseAbs().maxCoeff();
    EXPECT_EQ(winding.IsInside(p), reach < 2) << p;
    EXPECT_EQ(winding.IsOnSurface(p), reach == 2) << p;
  }
}

TEST(WindingNumber, OpenMeshes) {
  for (const double share : {0.01, 0.1, 0.5, 0.95}) {
    ExpectAngleSum(WithoutTriangles(Icosphere(1, 2), share, 4), 1.2, 5);
  }
}

TEST(WindingNumber, SoupsWithoutConnectivity) {
  std::mt19937 random(6);
  ExpectAngleSum(RandomSoup(100, 0.7, &random), 1, 7);
}

TEST(WindingNumber, NonManifoldAndMisorientedMeshes) {
  TriangleSoup soup = Icosphere(1, 1);
  std::mt19937 random(8);
  std::uniform_int_distribution<int> any(0, 41);
  for (Eigen::Index i = 0; i < 20; ++i) {
    soup.triangles(any(random), i % 3) = any(random);
  }
  ExpectAngleSum(soup, 1.2, 9);
}

TEST(WindingNumber, NestedAndInsideOut) {
  TriangleSoup inverted = Icosphere(1, 1);
  inverted.triangles.col(0).swap(inverted.triangles.col(1));
  const Solid hollow(inverted);
  EXPECT_EQ(hollow.winding.At(RowVector3d(0.1, 0.2, 0.3)), -1);
  EXPECT_FALSE(hollow.winding.IsInside(RowVector3d(0.1, 0.2, 0.3)));
  const Solid nested(Together(Icosphere(1, 1), Icosphere(2, 1)));
  EXPECT_EQ(nested.winding.At(RowVector3d(0, 0, 0)), 2);
  EXPECT_EQ(nested.winding.At(RowVector3d(0, 0, 1.2)), 1);
}

// The fan over the hole lies in the same plane as the points.
TEST(WindingNumber, PointsInThePlaneOfAHole) {
  TriangleSoup open = Box(2, 2, 2);
  open.triangles = open.triangles.bottomRows(open.triangles.rows() - 2).eval();
  const Solid solid(open);
  EXPECT_FALSE(solid.winding.IsClosed());
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (const double z : {-1.0, -1 - 1e-15, -1 + 1e-15, -1.5}) {
        const RowVector3d p(x / 4.0, y / 4.0, z);
        if (std::max(std::abs(x), std::abs(y)) == 4) continue;  // the rim
        EXPECT_NEAR(solid.winding.At(p), AngleSum(solid.bvh, p), kAngleRounding)
            << p;
      }
    }
  }
}

// Beside a diagonal of the hole one of the two fans over it is inaccurate. To
// multiply by a power of two changes no digit, so that the choice and the
// answer have to be the same.
TEST(WindingNumber, DoesNotDependOnTheUnitOfLength) {
  TriangleSoup open = Box(2, 2, 2);
  open.triangles = open.triangles.bottomRows(open.triangles.rows() - 2).eval();
  const Solid solid(open);
  for (const double unit : {0x1p-10, 0x1p10}) {
    TriangleSoup scaled = open;
    scaled.points *= unit;
    const Solid other(scaled);
    for (int x = -3; x <= 3; ++x) {
      for (int y = -3; y <= 3; ++y) {
        for (const double z : {-1 - 1e-12, -1 + 1e-12, -1 + 1e-3, 0.25}) {
          const RowVector3d p(x / 4.0, y / 4.0, z);
          const double expected = solid.winding.At(p);
          EXPECT_EQ(other.winding.At(unit * p), expected) << unit << ": " << p;
          EXPECT_NEAR(expected, AngleSum(solid.bvh, p), kAngleRounding) << p;
        }
      }
    }
  }
}

TEST(WindingNumber, FollowsTheTree) {
  TriangleSoup soup = WithoutTriangles(Icosphere(1, 2), 0.1, 10);
  Solid solid(soup);
  soup.points.rowwise() += RowVector3d(5, 6, 7);
  solid.bvh.Refit(soup.points);
  const RowVector3d p(5.1, 6.2, 7.3);
  EXPECT_NEAR(solid.winding.At(p), AngleSum(solid.bvh, p), kAngleRounding);
  EXPECT_GT(solid.winding.At(p), 0.5);
}

TEST(WindingNumber, NoTriangles) {
  const TriangleSoup empty = {Points(0, 3), Triangles(0, 3)};
  const Solid solid(empty);
  EXPECT_EQ(solid.winding.At(RowVector3d(0, 0, 0)), 0);
  EXPECT_FALSE(solid.winding.IsInside(RowVector3d(0, 0, 0)));
}

}  // namespace musclewarp
