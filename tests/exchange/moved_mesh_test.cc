// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/moved_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "exchange/star_mesh.h"
#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A ball in a ball, with a point in the middle: two layers of points inside.
TetrahedralMesh Layers(int* surface_points) {
  const TriangleSoup outer = Icosphere(10, 1);
  const auto count = static_cast<int>(outer.points.rows());
  TetrahedralMesh mesh;
  mesh.points.resize(2 * count, 3);
  mesh.points << outer.points, 0.5 * outer.points;
  // Each prism between the two balls is split into three tetrahedra, by the
  // numbers of its corners, so that neighbours fit.
  std::vector<Eigen::RowVector4i> rows;
  for (Eigen::Index f = 0; f < outer.triangles.rows(); ++f) {
    std::array<int, 3> c = {
        outer.triangles(f, 0), outer.triangles(f, 1), outer.triangles(f, 2)};
    std::sort(c.begin(), c.end());
    rows.emplace_back(c[0], c[1], c[2], c[2] + count);
    rows.emplace_back(c[0], c[1], c[1] + count, c[2] + count);
    rows.emplace_back(c[0], c[0] + count, c[1] + count, c[2] + count);
  }
  mesh.tetrahedra.resize(rows.size(), 4);
  for (size_t i = 0; i < rows.size(); ++i) mesh.tetrahedra.row(i) = rows[i];
  const Eigen::VectorXd volumes = Volumes(mesh);
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    if (volumes[t] < 0) {
      std::swap(mesh.tetrahedra(t, 0), mesh.tetrahedra(t, 1));
    }
  }
  AddStar(outer.triangles, count, Eigen::RowVector3d::Zero(), &mesh);
  *surface_points = count;
  return mesh;
}

TEST(HarmonicMover, FollowsAffineMotionsExactly) {
  int surface = 0;
  const TetrahedralMesh mesh = Layers(&surface);
  ASSERT_EQ(QualityOf(mesh).inverted, 0);
  const HarmonicMover mover(mesh, surface);
  Eigen::Affine3d motion =
      Eigen::Translation3d(100, -20, 3) *
      Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized());
  motion.linear() *= Eigen::Vector3d(0.7, 1.2, 1.1).asDiagonal();
  const Points expected = Transformed(mesh.points, motion.matrix());
  const TetrahedralMesh moved = mover.MoveTo(expected.topRows(surface));
  EXPECT_EQ(moved.points.topRows(surface), expected.topRows(surface));
  // Rounding of 100 mm in the solve.
  EXPECT_LT((moved.points - expected).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(moved.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(QualityOf(moved).inverted, 0);
}

TEST(HarmonicMover, PointsInsideStayWithinTheDisplacements) {
  // The maximum principle of harmonic functions; all dihedral angles of the
  // layers are acute enough for it.
  int surface = 0;
  const TetrahedralMesh mesh = Layers(&surface);
  const HarmonicMover mover(mesh, surface);
  Points target = mesh.points.topRows(surface);
  target.col(0).array() += 0.1 * target.col(2).array().square();
  const Points moved = mover.MoveTo(target).points;
  const Eigen::VectorXd steps = (moved - mesh.points).col(0);
  EXPECT_GT(steps.tail(moved.rows() - surface).minCoeff(), 0);
  EXPECT_LT(steps.tail(moved.rows() - surface).maxCoeff(),
            steps.head(surface).maxCoeff());
}

TEST(HarmonicMover, MayHaveNothingInside) {
  TetrahedralMesh mesh;
  mesh.points = UnitTetrahedron().points;
  mesh.tetrahedra.resize(1, 4);
  mesh.tetrahedra << 0, 1, 2, 3;
  const Points target = 2 * mesh.points;
  EXPECT_EQ(HarmonicMover(mesh, 4).MoveTo(target).points, target);
}

}  // namespace
}  // namespace musclewarp
