// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/folded_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <vector>

#include "musclewarp/mesh/triangle.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// The definition: a triangle is folded if its normal points away from that at
// rest, turned as the corners and their neighbours turn. Covariances are those
// of the edges of all triangles around a vertex, summed over the triangles
// around each of the three corners.
std::vector<int> FoldedByDefinition(const Points& rest,
                                    const Points& deformed,
                                    const Triangles& triangles) {
  using Matrices = std::vector<Eigen::Matrix3d>;
  Matrices edges(rest.rows(), Eigen::Matrix3d::Zero());
  Matrices around(rest.rows(), Eigen::Matrix3d::Zero());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles(f, k), b = triangles(f, (k + 1) % 3);
      const Eigen::Matrix3d edge = (rest.row(b) - rest.row(a)).transpose() *
                                   (deformed.row(b) - deformed.row(a));
      edges[a] += edge;
      edges[b] += edge;
    }
  }
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 9; ++k) {
      around[triangles(f, k / 3)] += edges[triangles(f, k % 3)];
    }
  }
  std::vector<int> folded;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::RowVector3i t = triangles.row(f);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
        around[t[0]] + around[t[1]] + around[t[2]],
        Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs(1, 1, 1);
    signs[2] = (svd.matrixV() * svd.matrixU().transpose()).determinant();
    const Eigen::Matrix3d rotation =
        svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
    const auto normal = [&](const Points& points) {
      return AreaVector(CornersOf(points, t));
    };
    if (normal(deformed).dot(normal(rest) * rotation.transpose()) < 0) {
      folded.push_back(static_cast<int>(f));
    }
  }
  return folded;
}

}  // namespace

TEST(FoldedTriangles, AreThoseOfTheDefinition) {
  const TriangleSoup sphere = Icosphere(10, 3);
  // From a few folded triangles to a heap in which no rotation is near another.
  for (const double noise : {1.0, 1.5, 3.0, 20.0}) {
    const Points crumpled =
        sphere.points +
        noise * RandomPoints(static_cast<int>(sphere.points.rows()), 7);
    std::vector<int> folded;
    for (const FoldedTriangle& triangle :
         FoldedTriangles(sphere.points, crumpled, sphere.triangles)) {
      folded.push_back(triangle.triangle);
    }
    EXPECT_EQ(folded,
              FoldedByDefinition(sphere.points, crumpled, sphere.triangles))
        << "noise " << noise;
    EXPECT_FALSE(folded.empty());
  }
}

TEST(FoldedTriangles, NoneInRigidOrSmoothMotion) {
  const TriangleSoup spindle = Spindle(5, 30, 3);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(3, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  Points moved = spindle.points * turn.transpose();
  moved.rowwise() += Eigen::RowVector3d(10, 20, 30);
  EXPECT_TRUE(
      FoldedTriangles(spindle.points, moved, spindle.triangles).empty());
  // Twisted by half a turn from end to end.
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    moved.row(i) =
        spindle.points.row(i) *
        Eigen::AngleAxisd(spindle.points(i, 2) / 20, Eigen::Vector3d::UnitZ())
            .toRotationMatrix()
            .transpose();
  }
  EXPECT_TRUE(
      FoldedTriangles(spindle.points, moved, spindle.triangles).empty());
}

TEST(FoldedTriangles, FindsTheOnesAroundAPushedVertex) {
  const TriangleSoup sphere = Icosphere(10, 3);
  // A vertex slid across its far neighbours turns triangles around it over.
  Points pushed = sphere.points;
  const int vertex = sphere.triangles(100, 0);
  const int across = sphere.triangles(100, 1);
  pushed.row(vertex) +=
      2.5 * (sphere.points.row(across) - sphere.points.row(vertex));
  const std::vector<FoldedTriangle> folded =
      FoldedTriangles(sphere.points, pushed, sphere.triangles);
  EXPECT_GE(folded.size(), 1u);
  EXPECT_LE(folded.size(), 6u);
  for (const FoldedTriangle& triangle : folded) {
    EXPECT_TRUE(
        (sphere.triangles.row(triangle.triangle).array() == vertex).any());
  }
}

// A triangle's rotation is searched from that of the one before, which is
// nearly right here and must not be taken as it is.
TEST(FoldedTriangles, ATinyTurnOfTheShapeTurnsTheRotationsByAsMuch) {
  const TriangleSoup one = Icosphere(10, 1);
  const int num_points = static_cast<int>(one.points.rows());
  const Points crumpled = one.points + 5 * RandomPoints(num_points, 7);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(5e-7, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  // Triangles 2 f and 2 f + 1 are the same of two spheres, of which the second
  // is turned as well.
  const Points rest = Together(one, one).points;
  Points deformed(rest.rows(), 3);
  deformed << crumpled, crumpled * turn.transpose();
  Triangles triangles(2 * one.triangles.rows(), 3);
  for (Eigen::Index f = 0; f < one.triangles.rows(); ++f) {
    triangles.row(2 * f) = one.triangles.row(f);
    triangles.row(2 * f + 1) = one.triangles.row(f).array() + num_points;
  }
  const std::vector<FoldedTriangle> folded =
      FoldedTriangles(rest, deformed, triangles);
  ASSERT_GT(folded.size(), 4u);
  ASSERT_EQ(folded.size() % 2, 0u);
  for (size_t i = 0; i < folded.size(); i += 2) {
    ASSERT_EQ(folded[i].triangle + 1, folded[i + 1].triangle);
    // The search ends when a rotation is right to the square of 1e-6, times
    // how badly the deformation determines it.
    constexpr double kSearch = 1e-9;
    EXPECT_LT((turn * folded[i].rotation - folded[i + 1].rotation).norm(),
              kSearch);
  }
}

TEST(FoldedTriangles, NeedlesDoNotCount) {
  // The corner of a needle moved across its long edge by a rounding.
  TriangleSoup soup = UnitTetrahedron();
  soup.points.row(3) << 0.5, 1e-13, 0;
  Points moved = soup.points;
  moved(3, 1) = -1e-13;
  EXPECT_THAT(FoldedTriangles(soup.points, moved, soup.triangles),
              ::testing::IsEmpty());
}

}  // namespace musclewarp
