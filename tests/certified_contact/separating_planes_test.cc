// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separating_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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
  const std::vector<TriangleBvh> trees = PredictedTrees(step);
  return FindPlanesBetweenMuscles({}, step, trees);
}

// Two spheres that are 0.4 mm apart, of which the smaller one goes along the
// other.
struct SphereAlongAnother {
  ContactGroup group;
  std::vector<Points> targets;
  ContactStep step;

  // `is_swapped`: the smaller one comes first.
  explicit SphereAlongAnother(bool is_swapped = false)
      : group(is_swapped ? std::vector<TriangleSoup>{Small(), Large()}
                         : std::vector<TriangleSoup>{Large(), Small()},
              {}),
        targets(group.state.targets),
        step(MakeContactStep(group.scene, group.state, MovedTargets(), {})) {}

  static TriangleSoup Large() { return SphereAt({0, 0, 0}, 10, 3); }
  static TriangleSoup Small() { return SphereAt({16.4, 0.3, 0.1}, 6, 3); }

 private:
  const std::vector<Points>& MovedTargets() {
    for (Points& points : targets) {
      if (points.col(0).mean() > 10) points.col(1).array() += 3;
    }
    return targets;
  }
};

// Whether a plane has all corners of a triangle below.
bool IsBelow(const SeparatingPlane& plane, const RowVector3i& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](int v) {
    return (plane.below.array() == v).any() ||
           std::binary_search(
               plane.also_below.begin(), plane.also_below.end(), v);
  });
}

TEST(FindPlanesBetweenMuscles, KeepsAllPairsApartThatAreNear) {
  const SphereAlongAnother spheres;
  const ContactStep& step = spheres.step;
  const std::vector<SeparatingPlane> planes = PlanesOf(step);
  const StepOptions options;
  const double radius =
      options.AimedGap() + options.planes.search_fraction * 2 * options.reach;
  const std::vector<TriangleBvh> predicted = PredictedTrees(step);
  const std::vector<TriangleBvh>& before = step.trees_before;
  // The smaller one, with as many triangles, is above.
  const Triangles &above = spheres.group.soups[1].triangles,
                  &below = spheres.group.soups[0].triangles;
  size_t pairs = 0;
  for (int f = 0; f < above.rows(); ++f) {
    for (int g = 0; g < below.rows(); ++g) {
      if (DistanceOf(before[1].corners(f), before[0].corners(g)) > radius &&
          DistanceOf(predicted[1].corners(f), predicted[0].corners(g)) >
              radius) {
        continue;
      }
      ++pairs;
      EXPECT_TRUE(std::any_of(planes.begin(),
                              planes.end(),
                              [&](const SeparatingPlane& plane) {
                                return plane.above == above.row(f) &&
                                       IsBelow(plane, below.row(g));
                              }))
          << f << " " << g;
    }
  }
  EXPECT_GT(pairs, 200u);
  // A plane serves for a patch of triangles.
  EXPECT_LT(3 * planes.size(), pairs);
}

TEST(FindPlanesBetweenMuscles, PutsAPlaneBetweenATriangleAndThoseBehind) {
  const SphereAlongAnother spheres;
  const ContactStep& step = spheres.step;
  const StepOptions options;
  for (const SeparatingPlane& plane : PlanesOf(step)) {
    EXPECT_EQ(plane.muscle_above, 1);
    EXPECT_EQ(plane.muscle_below, 0);
    const Points above = step.before.points[1](plane.above, Eigen::all);
    const Points below = step.before.points[0](plane.below, Eigen::all);
    EXPECT_NEAR(plane.distance, DistanceOf(above, below), kPlaneRounding);
    // Nothing turns, so that the two are apart by their distance before.
    const double front = (below * plane.normal.transpose()).maxCoeff();
    EXPECT_NEAR((above * plane.normal.transpose()).minCoeff() - front,
                plane.distance,
                kPlaneRounding);
    // What else is below leaves room for the gap.
    const double gap = options.AimedGap();
    const double beyond = std::max(0.0, plane.distance - gap) / 2 +
                          options.planes.overlooked_fraction * gap;
    for (const int v : plane.also_below) {
      EXPECT_LE(step.before.points[0].row(v).dot(plane.normal),
                front + beyond + kPlaneRounding);
      EXPECT_FALSE((plane.below.array() == v).any());
    }
  }
}

TEST(FindPlanesBetweenMuscles, DoesNotDependOnTheOrderOfTheMuscles) {
  const SphereAlongAnother one, other(/*is_swapped=*/true);
  const std::vector<SeparatingPlane> planes = PlanesOf(one.step),
                                     swapped = PlanesOf(other.step);
  ASSERT_EQ(planes.size(), swapped.size());
  for (size_t i = 0; i < planes.size(); ++i) {
    EXPECT_EQ(planes[i].muscle_above, 1 - swapped[i].muscle_above);
    EXPECT_EQ(planes[i].above, swapped[i].above);
    EXPECT_EQ(planes[i].below, swapped[i].below);
    EXPECT_EQ(planes[i].also_below, swapped[i].also_below);
    EXPECT_EQ(planes[i].normal, swapped[i].normal);
  }
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
