// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/winding_number.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

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
  std::mt19937 engine(4);
  for (int i = 0; i < 2000; ++i) {
    Eigen::RowVector3d p;
    for (int k = 0; k < 3; ++k) p[k] = 30 * (engine() / 4294967296.0) - 15;
    const double expected = BySolidAngles(soup, p);
    // A few hundred angles of size 1 rounded.
    EXPECT_NEAR(winding.At(p), expected, 1e-10);
    if (std::abs(expected - 0.5) > 1e-6) {
      EXPECT_EQ(winding.IsInside(p), expected > 0.5);
    }
  }
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
    const Eigen::RowVector3d p(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3);
    const double reach = p.cwiseAbs().maxCoeff();
    EXPECT_EQ(winding.IsInside(p), reach < 2) << p;
    EXPECT_EQ(winding.IsOnSurface(p), reach == 2) << p;
  }
}

}  // namespace musclewarp
