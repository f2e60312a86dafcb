// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/triangle_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "certificate/surface_views.h"
#include "musclewarp/certificate/mesh_distance.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(TriangleClusters, HaveEveryTriangleOnce) {
  const TriangleSoup sphere = Icosphere(10, 3);
  const TriangleClusters clusters(sphere.points, sphere.triangles);
  EXPECT_EQ(clusters.num_triangles(), sphere.triangles.rows());
  std::multiset<int> all;
  for (int c = 0; c < clusters.size(); ++c) {
    EXPECT_LE(clusters.end(c) - clusters.begin(c), 16);
    EXPECT_TRUE(std::is_sorted(clusters.begin(c), clusters.end(c)));
    all.insert(clusters.begin(c), clusters.end(c));
  }
  EXPECT_EQ(static_cast<Eigen::Index>(all.size()), sphere.triangles.rows());
  EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), all.size());
}

TEST(TriangleClusters, HaveBoxesAroundTheirTrianglesWhereverTheseAre) {
  TriangleSoup sphere = Icosphere(10, 2);
  const TriangleClusters clusters(sphere.points, sphere.triangles);
  sphere.points += 30 * RandomPoints(sphere.points.rows(), 2);
  const std::vector<RoundedBox> boxes = clusters.BoxesAt(sphere.points);
  ASSERT_EQ(static_cast<int>(boxes.size()), clusters.size());
  for (int c = 0; c < clusters.size(); ++c) {
    for (const int* f = clusters.begin(c); f < clusters.end(c); ++f) {
      for (const int v : sphere.triangles.row(*f)) {
        for (int k = 0; k < 3; ++k) {
          EXPECT_LE(boxes[c].lower[k], sphere.points(v, k));
          EXPECT_GE(boxes[c].upper[k], sphere.points(v, k));
        }
      }
    }
  }
}

TEST(TriangleClusters, MayBeEmpty) {
  const TriangleClusters none({}, {});
  EXPECT_EQ(none.size(), 0);
  EXPECT_TRUE(none.BoxesAt({}).empty());
}

// Clusters of triangles that are anywhere cost time and change no result.
TEST(TriangleClusters, OfAnotherPoseChangeNoResult) {
  const TriangleSoup ball = Icosphere(10, 3);
  const TriangleClusters wrong(RandomPoints(ball.points.rows(), 8),
                               ball.triangles);
  SurfaceView hinted = ViewOf(ball);
  hinted.clusters = &wrong;
  for (const double apart : {19.0, 20.3, 23.0}) {
    const TriangleSoup other = MovedBy(Icosphere(10, 3), {apart, 0.3, 0.1});
    EXPECT_EQ(CrossingTriangles({ViewOf(other)}, {hinted}).size(),
              CrossingTriangles({ViewOf(other)}, {ViewOf(ball)}).size());
    const BoxedMesh boxed_other(ViewOf(other));
    const DistanceSearch search(boxed_other, 2);
    const auto with = search.To(BoxedMesh(hinted));
    const auto without = search.To(BoxedMesh(ViewOf(ball)));
    ASSERT_EQ(with.has_value(), without.has_value());
    if (!with) continue;
    EXPECT_EQ(with->at_least, without->at_least);
    EXPECT_EQ(with->at_most, without->at_most);
    EXPECT_EQ(with->triangle_of_a, without->triangle_of_a);
    EXPECT_EQ(with->triangle_of_b, without->triangle_of_b);
  }
}

}  // namespace
}  // namespace musclewarp
