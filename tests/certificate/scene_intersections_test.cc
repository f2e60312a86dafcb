// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/scene_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

TEST(SceneIntersections, MeasureGapsOfPairsThatAreNear) {
  // The box is 0.5 mm from one muscle, 0.25 mm from a bone, and far from the
  // other bone.
  const SearchableMesh a(Box(10, 10, 10));
  const SearchableMesh b(MovedBy(Box(10, 10, 10), {10.5, 0, 0}));
  const SearchableMesh near(MovedBy(Box(10, 10, 10), {0, 10.25, 0}));
  const SearchableMesh far(MovedBy(Box(10, 10, 10), {0, 0, 10 + 2.5}));
  const SceneIntersections found =
      IntersectScene({{"a", &a}, {"b", &b}}, {{"near", &near}, {"far", &far}});
  ASSERT_EQ(found.gaps.size(), 3u);
  EXPECT_EQ(found.gaps[0].b, "b");
  EXPECT_EQ(found.gaps[1].b, "near");
  // Some roundings of coordinates of 10 mm.
  constexpr double kGapRounding = 1e-13;
  EXPECT_NEAR(found.gaps[0].at_least_mm, 0.5, kGapRounding);
  EXPECT_LE(found.gaps[0].at_least_mm, 0.5);
  EXPECT_GE(found.gaps[0].at_most_mm, 0.5);
  EXPECT_NEAR(found.gaps[0].place[0], 5.25, kGapRounding);
  EXPECT_NEAR(found.gaps[1].at_least_mm, 0.25, kGapRounding);
  // The box b and the near bone are nearest at their edges.
  EXPECT_EQ(found.gaps[2].a, "b");
  EXPECT_NEAR(found.gaps[2].at_least_mm, std::hypot(0.5, 0.25), kGapRounding);
  EXPECT_EQ(found.SmallestGap(), found.gaps[1].at_least_mm);
}

TEST(SceneIntersections, MeshesThatIntersectHaveNoGap) {
  const Balls balls;
  const SceneIntersections found = IntersectScene(balls.muscles, balls.bones);
  ASSERT_EQ(found.gaps.size(), 1u);
  EXPECT_EQ(found.gaps[0].at_most_mm, 0);
  EXPECT_EQ(found.gaps[0].place, found.pairs[0].place);
  // The surfaces of a ball and what it contains are apart, the bodies are not.
  const SearchableMesh core(Icosphere(2, 1));
  const SceneIntersections inside =
      IntersectScene({balls.muscles[0]}, {{"core", &core}});
  ASSERT_EQ(inside.gaps.size(), 1u);
  EXPECT_EQ(inside.SmallestGap(), 0);
  EXPECT_NEAR(inside.gaps[0].place.norm(), 2, 1e-12);  // a vertex of the core
  EXPECT_EQ(IntersectScene({balls.muscles[0]}, {}).SmallestGap(), std::nullopt);
}

TEST(SceneIntersections, ExemptTrianglesHaveNoGap) {
  const SearchableMesh muscle(LatticeBox(4, 4, 4));
  const SearchableMesh bone(MovedBy(Box(1, 1, 1), {5, 2, 2}));
  ExemptArea area;
  area.muscle = 0;
  area.bone = 0;
  area.vertices.assign(muscle.points().rows(), 0);
  area.triangles.assign(muscle.triangles().rows(), 0);
  for (Eigen::Index v = 0; v < muscle.points().rows(); ++v) {
    area.vertices[v] = muscle.points()(v, 0) == 4;
  }
  for (Eigen::Index f = 0; f < muscle.triangles().rows(); ++f) {
    for (const int v : muscle.triangles().row(f)) {
      area.triangles[f] |= area.vertices[v];
    }
  }
  const std::vector<NamedMesh> muscles = {{"m", &muscle}};
  const std::vector<NamedMesh> bones = {{"b", &bone}};
  EXPECT_NEAR(*IntersectScene(muscles, bones).SmallestGap(), 0.5, 1e-13);
  // The nearest triangles without a corner in the area end at x = 3.
  const auto exempt = IntersectScene(muscles, bones, {area}).SmallestGap();
  EXPECT_FALSE(exempt);
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
