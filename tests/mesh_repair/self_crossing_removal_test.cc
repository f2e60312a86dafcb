// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/self_crossing_removal.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Expects that a mesh is repaired, and that vertices farther than `reach` (mm)
// from `place` are the same in the same order.
void ExpectRepairedNear(const RowVector3d& place,
                        double reach,
                        const TriangleSoup& crossing) {
  const int pairs = static_cast<int>(SelfIntersections(crossing).size());
  ASSERT_GT(pairs, 0);
  TriangleSoup soup = crossing;
  const SelfCrossingRemoval removal = RemoveSelfCrossings(&soup);
  EXPECT_EQ(removal.pairs_before, pairs);
  EXPECT_EQ(removal.pairs_after, 0);
  EXPECT_TRUE(SelfIntersections(soup).empty());
  EXPECT_TRUE(CountDefects(soup).IsClean());
  const auto far_points = [&](const TriangleSoup& mesh) {
    std::vector<std::array<double, 3>> far;
    for (const auto p : mesh.points.rowwise()) {
      if ((p - place).norm() > reach) far.push_back({p[0], p[1], p[2]});
    }
    return far;
  };
  EXPECT_EQ(far_points(soup), far_points(crossing));
  if (removal.new_vertices > 0) {
    EXPECT_LT((removal.place - place).norm(), reach);
    EXPECT_LT(removal.farthest, reach);
  }
}

}  // namespace

TEST(RemoveSelfCrossings, AMeshWithoutThemStaysAsItIs) {
  const TriangleSoup ball = Icosphere(20, 3);
  TriangleSoup soup = ball;
  const SelfCrossingRemoval removal = RemoveSelfCrossings(&soup);
  EXPECT_EQ(removal.pairs_before, 0);
  EXPECT_EQ(removal.pairs_after, 0);
  EXPECT_EQ(removal.new_vertices, 0);
  EXPECT_EQ(soup.points, ball.points);
  EXPECT_EQ(soup.triangles, ball.triangles);
}

TEST(RemoveSelfCrossings, AVertexBesideItsNeighboursComesBack) {
  // A vertex is moved beyond its neighbours, within the surface.
  TriangleSoup soup = Icosphere(20, 3);
  const RowVector3d place = soup.points.row(100);
  RowVector3d aside = place.cross(RowVector3d(1, 2, 3)).normalized();
  soup.points.row(100) += 7 * aside - 0.05 * place;
  ExpectRepairedNear(place, 16, soup);
}

TEST(RemoveSelfCrossings, SwappedNeighboursAreRepaired) {
  TriangleSoup soup = Icosphere(20, 3);
  const int a = soup.triangles(200, 0), b = soup.triangles(200, 1);
  const RowVector3d place = soup.points.row(a);
  soup.points.row(a).swap(soup.points.row(b));
  ExpectRepairedNear(place, 16, soup);
}

TEST(RemoveSelfCrossings, AVertexThroughTheOppositeSideIsTakenBack) {
  // A flat spindle, one vertex of which is pushed through the other side.
  TriangleSoup soup = Icosphere(20, 3);
  soup.points.col(2) *= 0.1;
  Eigen::Index top;
  soup.points.col(2).maxCoeff(&top);
  const RowVector3d place = soup.points.row(top);
  soup.points(top, 2) = -3;
  ExpectRepairedNear(place, 12, soup);
}

TEST(RemoveSelfCrossings, SurfacesOfOneMeshMayCrossEachOther) {
  TriangleSoup soup = Together(Icosphere(10, 2), SphereAt({15, 0, 0}, 10, 2));
  const TriangleSoup before = soup;
  const SelfCrossingRemoval removal = RemoveSelfCrossings(&soup);
  EXPECT_EQ(removal.pairs_before, 0);
  EXPECT_EQ(soup.points, before.points);
  EXPECT_EQ(soup.triangles, before.triangles);
}

TEST(RemoveSelfCrossings, OfSeveralSurfacesOnlyTheOneThatCrossesChanges) {
  TriangleSoup crossing = Icosphere(20, 3);
  crossing.points.col(2) *= 0.1;
  Eigen::Index top;
  crossing.points.col(2).maxCoeff(&top);
  crossing.points(top, 2) = -3;
  const TriangleSoup ball = SphereAt({15, 0, 0}, 10, 2);
  TriangleSoup soup = Together(crossing, ball);
  const SelfCrossingRemoval removal = RemoveSelfCrossings(&soup);
  EXPECT_GT(removal.pairs_before, 0);
  EXPECT_EQ(removal.pairs_after, 0);
  EXPECT_EQ(soup.points.bottomRows(ball.points.rows()), ball.points);
}

}  // namespace musclewarp
