// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/defects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "certified_contact/contact_group.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

struct Moved {
  ContactGroup group;
  StepOptions options;
  ContactStep step;
  std::vector<Points> points;

  explicit Moved(ContactGroup contact_group)
      : group(std::move(contact_group)),
        step(MakeContactStep(group.scene,
                             group.state,
                             group.state.targets,
                             group.state.bones_from_rest)),
        points(group.state.points) {}

  Defects Find() const {
    std::vector<TriangleBvh> trees = PredictedTrees(step);
    return FindDefects(options, step, group.state.targets, points, &trees);
  }
  std::vector<SeparatingPlane> Planes(const Defects& defects) const {
    return PlanesAgainst(defects, options, step, group.state.targets);
  }
};

TEST(FindDefects, FindsNothingWhereNothingIsWrong) {
  const Moved moved(SpheresOverABone());
  const Defects defects = moved.Find();
  EXPECT_FALSE(defects.HasCrossings());
  EXPECT_EQ(defects.num_folded(), 0);
  EXPECT_TRUE(moved.Planes(defects).empty());
}

TEST(FindDefects, CountsEveryPairOfTwoMeshesThatCrosses) {
  Moved moved(SpheresOverABone());
  moved.points[0] += Points::Zero(moved.points[0].rows(), 3);
  moved.points[0].rowwise() += RowVector3d(1, 0, -1);
  const Defects defects = moved.Find();
  const TriangleBvh first(moved.points[0], moved.group.soups[0].triangles);
  const TriangleBvh second(moved.points[1], moved.group.soups[1].triangles);
  EXPECT_EQ(defects.muscle_crossings.size(),
            IntersectingTriangles(first, second).size());
  EXPECT_EQ(defects.bone_crossings.size(),
            IntersectingTriangles(first, *moved.group.scene.bones[0]).size());
  EXPECT_GT(defects.muscle_crossings.size(), 0u);
  EXPECT_GT(defects.bone_crossings.size(), 0u);
  EXPECT_EQ(defects.num_crossings(),
            static_cast<int>(defects.muscle_crossings.size() +
                             defects.bone_crossings.size()));
  // All were apart before the step, so that each gets a plane.
  const auto planes = moved.Planes(defects);
  EXPECT_EQ(static_cast<int>(planes.size()), defects.num_crossings());
  EXPECT_EQ(std::count_if(planes.begin(),
                          planes.end(),
                          [](const auto& plane) { return plane.IsOfBone(); }),
            static_cast<long>(defects.bone_crossings.size()));
}

TEST(FindDefects, PassesOverExemptTriangles) {
  Moved moved(SpheresOverABone());
  moved.points[0].rowwise() += RowVector3d(0, 0, -1);
  EXPECT_GT(moved.Find().bone_crossings.size(), 0u);
  moved.group.scene.muscles[0].exempt = {
      std::vector<char>(moved.group.soups[0].triangles.rows(), true)};
  EXPECT_EQ(moved.Find().bone_crossings.size(), 0u);
}

TEST(FindDefects, FindsATriangleThatFoldedAndUnfoldsIt) {
  Moved moved(ContactGroup({SphereAt({0, 0, 0}, 10, 2)}, {}));
  moved.options.defects.max_folded_fraction = 0;
  // Vertex 0 goes beyond the ring around it.
  const MuscleSurface& surface = moved.group.scene.muscles[0];
  const int neighbour = surface.neighbours[surface.first[0]];
  moved.points[0].row(0) +=
      2.2 * (moved.points[0].row(neighbour) - moved.points[0].row(0));
  const Defects defects = moved.Find();
  ASSERT_GT(defects.num_folded(), 0);
  int planes_of_folds = 0;
  for (const SeparatingPlane& plane : moved.Planes(defects)) {
    EXPECT_TRUE(plane.IsWithinOneMuscle());
    // Where the target is, the corner is above the opposite edge.
    const Points& target = moved.group.state.targets[0];
    if (plane.shared_corner >= 0 || plane.above[0] != plane.above[1]) continue;
    ++planes_of_folds;
    EXPECT_GT(plane.normal.dot(target.row(plane.above[0])),
              plane.normal.dot(target.row(plane.below[0])));
  }
  EXPECT_GE(planes_of_folds, defects.num_folded());
}

TEST(FindDefects, AllowsSomeFoldedTriangles) {
  Moved moved(ContactGroup({SphereAt({0, 0, 0}, 10, 2)}, {}));
  const MuscleSurface& surface = moved.group.scene.muscles[0];
  const int neighbour = surface.neighbours[surface.first[0]];
  moved.points[0].row(0) +=
      2.2 * (moved.points[0].row(neighbour) - moved.points[0].row(0));
  moved.options.defects.max_folded_fraction = 1;
  EXPECT_EQ(moved.Find().num_folded(), 0);
}

TEST(FindDefects, SeparatesAMuscleThatCrossesItself) {
  Moved moved(ContactGroup({SphereAt({0, 0, 0}, 10, 2)}, {}));
  moved.points[0].row(0) *= -1.05;  // through the opposite side
  const Defects defects = moved.Find();
  ASSERT_GT(defects.self_crossings.size(), 0u);
  EXPECT_EQ(defects.num_crossings(), 0);
  EXPECT_TRUE(defects.HasCrossings());
  const Stiffness stiffness = Stiffened(defects,
                                        moved.options.defects,
                                        moved.group.scene,
                                        UniformStiffness(moved.group.scene));
  EXPECT_GE(stiffness[0][0], moved.options.defects.stiffening);
  EXPECT_EQ(stiffness[0].minCoeff(), 1);
}

TEST(Stiffened, AllCornersOfBothTrianglesThatCross) {
  const Moved moved(ContactGroup(
      {SphereAt({0, 0, 0}, 10, 2), SphereAt({30, 0, 0}, 10, 2)}, {}));
  const Triangles& triangles = moved.group.soups[0].triangles;
  const int f = 0, g = static_cast<int>(triangles.rows()) - 1;
  Defects defects;
  defects.folded.resize(2);
  defects.self_crossings = {{0, f, 0, g}};
  const Stiffness stiffness = Stiffened(defects,
                                        moved.options.defects,
                                        moved.group.scene,
                                        UniformStiffness(moved.group.scene));
  for (int v = 0; v < stiffness[0].size(); ++v) {
    const bool is_corner = (triangles.row(f).array() == v).any() ||
                           (triangles.row(g).array() == v).any();
    EXPECT_EQ(stiffness[0][v],
              is_corner ? moved.options.defects.stiffening : 1);
  }
  EXPECT_EQ(stiffness[1].maxCoeff(), 1);
}

TEST(FindDefects, LeavesCrossingsThatNoPlaneCanSeparate) {
  TriangleSoup soup = SphereAt({0, 0, 0}, 10, 2);
  soup.points.row(0) *= -1.05;
  ASSERT_FALSE(SelfIntersections(soup).empty());
  // They cross before the step and where the coarse mesh has them.
  const Moved moved(ContactGroup({soup}, {}));
  EXPECT_FALSE(moved.Find().HasCrossings());
}

TEST(Stiffened, GrowsToALimit) {
  Moved moved(ContactGroup({SphereAt({0, 0, 0}, 10, 1)}, {}));
  Defects defects;
  defects.folded = {{{0, Eigen::Matrix3d::Identity()}}};
  Stiffness stiffness = UniformStiffness(moved.group.scene);
  for (int i = 0; i < 10; ++i) {
    stiffness =
        Stiffened(defects, moved.options.defects, moved.group.scene, stiffness);
  }
  EXPECT_EQ(stiffness[0].maxCoeff(), moved.options.defects.max_stiffness);
  EXPECT_EQ((stiffness[0].array() > 1).count(), 3);
}

}  // namespace
}  // namespace musclewarp
