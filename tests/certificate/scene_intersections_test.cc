// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/scene_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// Two balls of radius 10, 18 mm apart, and a third 30 mm from the first.
struct Balls {
  SearchableMesh a{Icosphere(10, 3)};
  SearchableMesh b{MovedBy(Icosphere(10, 3), {18, 0, 0})};
  SearchableMesh bone{MovedBy(Icosphere(10, 3), {-30, 0, 0})};
  std::vector<NamedMesh> muscles = {{"a", &a}, {"b", &b}};
  std::vector<NamedMesh> bones = {{"bone", &bone}};
};

TEST(SceneIntersections, KnowsTheVerticesInside) {
  const Balls balls;
  const SceneIntersections found = IntersectScene(balls.muscles, balls.bones);
  ASSERT_EQ(found.inside_of_muscles.size(), 2u);
  EXPECT_EQ(static_cast<int>(found.inside_of_muscles[0].size() +
                             found.inside_of_muscles[1].size()),
            found.vertices_inside);
  EXPECT_GT(found.vertices_inside, 0);
  for (const int v : found.inside_of_muscles[0]) {
    EXPECT_LT((balls.a.points().row(v) - Eigen::RowVector3d(18, 0, 0)).norm(),
              10);
  }
}

TEST(SceneIntersections, FindsWhatLiesWhollyInside) {
  const SearchableMesh ball(Icosphere(10, 3));
  const SearchableMesh core(MovedBy(Icosphere(2, 2), {3, 0, 0}));
  for (const bool is_bone : {false, true}) {
    std::vector<NamedMesh> muscles = {{"ball", &ball}}, bones;
    (is_bone ? bones : muscles).push_back({"core", &core});
    const SceneIntersections found = IntersectScene(muscles, bones);
    EXPECT_EQ(found.triangle_pairs, 0);
    EXPECT_EQ(found.vertices_inside, core.points().rows());
    EXPECT_FALSE(found.IsClean());
  }
}

TEST(VertexGaps, AreDistancesNegativeInside) {
  const Balls balls;
  const SceneIntersections found = IntersectScene(balls.muscles, balls.bones);
  constexpr double kLimit = 11;
  const Eigen::VectorXd gaps = VertexGaps(
      0, balls.muscles, balls.bones, found.inside_of_muscles[0], kLimit);
  // An icosphere of this fineness lies up to 0.15 mm inside its sphere.
  constexpr double kFacets = 0.15;
  for (Eigen::Index v = 0; v < gaps.size(); ++v) {
    const Eigen::RowVector3d p = balls.a.points().row(v);
    const double to_b = (p - Eigen::RowVector3d(18, 0, 0)).norm() - 10;
    const double to_bone = (p - Eigen::RowVector3d(-30, 0, 0)).norm() - 10;
    EXPECT_NEAR(gaps[v], std::min({to_b, to_bone, kLimit}), kFacets);
  }
  EXPECT_LT(gaps.minCoeff(), -1.5);
}

}  // namespace
}  // namespace musclewarp
