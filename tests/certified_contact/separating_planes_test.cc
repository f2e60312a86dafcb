// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separating_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "certified_contact/contact_group.h"
#include "musclewarp/mesh/transformed.h"
#include "proximity/triangle_distances.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// Of coordinates of size 20.
constexpr double kPlaneRounding = 1e-9;

std::vector<SeparatingPlane> PlanesOf(const ContactStep& step) {
  std::vector<TriangleBvh> trees = PredictedTrees(step);
  return FindPlanesBetweenMuscles({}, step, &trees);
}

int TriangleWith(const Triangles& triangles, const RowVector3i& corners) {
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (triangles.row(f) == corners) return static_cast<int>(f);
  }
  return -1;
}

TEST(FindPlanesBetweenMuscles, FindsAllPairsOfMusclesThatAreNear) {
  const ContactGroup group(
      {SphereAt({0, 0, 0}, 10, 3), SphereAt({16.4, 0.3, 0.1}, 6, 3)}, {});
  // The second comes along the first.
  std::vector<Points> targets = group.state.targets;
  targets[1].col(1).array() += 3;
  const ContactStep step =
      MakeContactStep(group.scene, group.state, targets, {});
  const StepOptions options;
  const double radius =
      options.AimedGap() + options.planes.search_fraction * 2 * options.reach;
  const std::vector<TriangleBvh> predicted = PredictedTrees(step);
  const std::vector<TriangleBvh>& before = step.trees_before;
  std::set<std::pair<int, int>> expected;
  for (int f = 0; f < before[0].num_triangles(); ++f) {
    for (int g = 0; g < before[1].num_triangles(); ++g) {
      if (DistanceOf(before[0].corners(f), before[1].corners(g)) <= radius ||
          DistanceOf(predicted[0].corners(f), predicted[1].corners(g)) <=
              radius) {
        expected.emplace(f, g);
      }
    }
  }
  std::set<std::pair<int, int>> found;
  for (const SeparatingPlane& plane : PlanesOf(step)) {
    EXPECT_EQ(plane.muscle_above, 0);
    EXPECT_EQ(plane.muscle_below, 1);
    const int f = TriangleWith(group.soups[0].triangles, plane.above);
    const int g = TriangleWith(group.soups[1].triangles, plane.below);
    found.emplace(f, g);
    EXPECT_NEAR(plane.distance,
                DistanceOf(before[0].corners(f), before[1].corners(g)),
                kPlaneRounding);
    // Nothing turns, so that the two are apart by their distance before.
    const double room =
        (before[0].corners(f) * plane.normal.transpose()).minCoeff() -
        (before[1].corners(g) * plane.normal.transpose()).maxCoeff();
    EXPECT_NEAR(room, plane.distance, kPlaneRounding);
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 20u);
}

TEST(PlaneBetween, TurnsAsTheTrianglesDo) {
  const ContactGroup group(
      {SphereAt({0, 0, 0}, 10, 2), SphereAt({20.5, 0, 0}, 10, 2)}, {});
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<2, 2>() << 0, -1, 1, 0;  // by 90 degrees about z
  std::vector<Points> targets;
  for (const Points& points : group.state.points) {
    targets.push_back(Transformed(points, turn));
  }
  const ContactStep step =
      MakeContactStep(group.scene, group.state, targets, {});
  const TriangleSeparation along_x = {RowVector3d(-1, 0, 0), 0.5};
  const SeparatingPlane plane = PlaneBetween(step, 0, 3, 1, 7, along_x, 0.05);
  EXPECT_LT((plane.normal - RowVector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_EQ(plane.half_gap, 0.05);
  EXPECT_EQ(plane.distance, 0.5);
  EXPECT_EQ(plane.above, group.soups[0].triangles.row(3));
  EXPECT_EQ(plane.below, group.soups[1].triangles.row(7));
}

}  // namespace
}  // namespace musclewarp
