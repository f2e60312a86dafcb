// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/drawn_out_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/invalid_options.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::Contains;

// A sphere of radius 20 mm.
TriangleSoup Ball() { return Icosphere(20, 4); }

std::vector<bool> NoneLocked(const TriangleSoup& mesh) {
  return std::vector<bool>(mesh.points.rows(), false);
}

// Returns a neighbour of a vertex.
int NeighbourOf(const TriangleSoup& mesh, int v) {
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles(f, k) == v) return mesh.triangles(f, (k + 1) % 3);
    }
  }
  ADD_FAILURE() << "vertex " << v << " has no triangles";
  return -1;
}

// Moves a vertex along its edge to a neighbour until a share of it is left.
void Approach(int v, double share, TriangleSoup* mesh) {
  const int u = NeighbourOf(*mesh, v);
  mesh->points.row(v) =
      mesh->points.row(u) + share * (mesh->points.row(v) - mesh->points.row(u));
}

double LargestStretch(const TriangleSoup& rest, const Points& moved) {
  return TriangleStretches(rest.points, moved, rest.triangles).maxCoeff();
}

constexpr int kVertex = 100;

}  // namespace

TEST(RemoveDrawnOutTriangles, AMeshThatMovesRigidlyStaysAsItIs) {
  const TriangleSoup ball = Ball();
  Points moved = ball.points(Eigen::all, {1, 2, 0});
  moved.rowwise() += Eigen::RowVector3d(1, 2, 3);
  TriangleSoup rest = ball;
  const std::vector<int> kept =
      RemoveDrawnOutTriangles({}, moved, NoneLocked(rest), &rest);
  EXPECT_EQ(rest.points, ball.points);
  EXPECT_EQ(rest.triangles.rows(), ball.triangles.rows());
  std::vector<int> all(ball.points.rows());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(kept, all);
}

// At rest a vertex is close to its neighbour; then it is where it is in an even
// mesh, so that the triangles between them grow fivefold.
TEST(RemoveDrawnOutTriangles, AVertexThatIsDrawnAwayFromAnotherVanishes) {
  const Points moved = Ball().points;
  TriangleSoup rest = Ball();
  Approach(kVertex, 0.2, &rest);
  const TriangleSoup before = rest;
  ASSERT_GT(LargestStretch(rest, moved), 2);
  const std::vector<int> kept =
      RemoveDrawnOutTriangles({}, moved, NoneLocked(rest), &rest);
  EXPECT_LE(LargestStretch(rest, Points(moved(kept, Eigen::all))),
            DrawnOutOptions().max_stretch);
  EXPECT_EQ(rest.triangles.rows(), before.triangles.rows() - 2);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(rest.points, Points(before.points(kept, Eigen::all)));
  EXPECT_TRUE(CountDefects(rest).is_closed_manifold);
  // One triangle fan of 256 of the sphere is less flat.
  EXPECT_NEAR(SignedVolume(rest.points, rest.triangles) /
                  SignedVolume(before.points, before.triangles),
              1,
              1e-3);
}

TEST(RemoveDrawnOutTriangles, LockedVerticesStay) {
  const Points moved = Ball().points;
  TriangleSoup rest = Ball();
  Approach(kVertex, 0.2, &rest);
  std::vector<bool> locked = NoneLocked(rest);
  locked[kVertex] = true;
  const std::vector<int> kept =
      RemoveDrawnOutTriangles({}, moved, locked, &rest);
  EXPECT_THAT(kept, Contains(kVertex));
}

// A peak of 5 mm is a feature of the surface, however far it was drawn out.
TEST(RemoveDrawnOutTriangles, DoesNotFlattenTheSurface) {
  TriangleSoup rest = Ball();
  Points moved = rest.points;
  moved.row(kVertex) *= 1.25;
  const std::vector<int> kept =
      RemoveDrawnOutTriangles({}, moved, NoneLocked(rest), &rest);
  EXPECT_THAT(kept, Contains(kVertex));
}

TEST(DrawnOutOptions, AreChecked) {
  ExpectValid(DrawnOutOptions());
  ExpectRefused<DrawnOutOptions>(
      [](auto* options) { options->max_stretch = 0.9; },
      "DrawnOutOptions::max_stretch is 0.9, allowed: 1 or above");
  ExpectRefused<DrawnOutOptions>(
      [](auto* options) { options->max_deviation = -1; },
      "DrawnOutOptions::max_deviation is -1, allowed: 0 or above");
}

}  // namespace musclewarp
