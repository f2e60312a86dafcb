// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/bone_planes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

#include "certified_contact/contact_group.h"
#include "musclewarp/mesh/transformed.h"
#include "proximity/triangle_distances.h"

namespace musclewarp {
namespace {

// Of coordinates of size 20.
constexpr double kBonePlaneRounding = 1e-9;

Eigen::Matrix4d ShiftBy(double x, double y, double z) {
  Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
  shift.topRightCorner<3, 1>() << x, y, z;
  return shift;
}

// The planes of a step, and those that the next one begins with.
struct PlanesOfStep {
  std::vector<SeparatingPlane> planes;
  std::shared_ptr<KeptBonePlanes> kept = std::make_shared<KeptBonePlanes>();
};

PlanesOfStep PlanesFor(const ContactStep& step) {
  PlanesOfStep found;
  found.planes = FindPlanesOfBones({}, step, found.kept.get());
  return found;
}

std::vector<SeparatingPlane> PlanesOf(const ContactStep& step) {
  return PlanesFor(step).planes;
}

// A step of a group in which nothing moves.
PlanesOfStep PlanesAtRest(const ContactGroup& group) {
  return PlanesFor(MakeContactStep(group.scene,
                                   group.state,
                                   group.state.targets,
                                   group.state.bones_from_rest));
}

void Move(const Eigen::Matrix4d& motion, ContactState* state) {
  for (Points& points : state->points) points = Transformed(points, motion);
  for (Points& targets : state->targets) {
    targets = Transformed(targets, motion);
  }
}

void ExpectEqual(const std::vector<SeparatingPlane>& a,
                 const std::vector<SeparatingPlane>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].above, b[i].above);
    EXPECT_EQ(a[i].normal, b[i].normal);
    EXPECT_EQ(a[i].level, b[i].level);
  }
}

// The part of a bone within `radius` of a triangle of the first muscle is
// behind one of the planes of this triangle, for every triangle.
void ExpectAllOfTheBoneBehind(const ContactGroup& group,
                              const std::vector<SeparatingPlane>& planes,
                              double radius) {
  const TriangleBvh& bone = *group.scene.bones[0];
  const Triangles& triangles = group.soups[0].triangles;
  int compared = 0;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Corners corners = CornersOf(group.state.points[0], triangles.row(f));
    for (int g = 0; g < bone.num_triangles(); ++g) {
      if (DistanceOf(corners, bone.corners(g)) > radius) continue;
      ++compared;
      EXPECT_TRUE(std::any_of(
          planes.begin(), planes.end(), [&](const SeparatingPlane& plane) {
            return plane.muscle_above == 0 && plane.above == triangles.row(f) &&
                   (bone.corners(g) * plane.normal.transpose()).maxCoeff() <
                       plane.level;
          }));
    }
  }
  EXPECT_GT(compared, 100);
}

double Margin() {
  const StepOptions options;
  return options.AimedGap() + options.planes.search_fraction * options.reach;
}

ContactGroup SphereOverAFineBone() {
  return ContactGroup({SphereAt({0, 0, 10.5}, 10, 3)},
                      {SphereAt({0, 0, -20}, 20, 4)});
}

TEST(FindPlanesOfBones, PlanesOfABoneMoveWithIt) {
  const ContactGroup group = SpheresOverABone();
  const ContactStep still = MakeContactStep(
      group.scene, group.state, group.state.targets, {ShiftBy(0, 0, 0)});
  const ContactStep raised = MakeContactStep(
      group.scene, group.state, group.state.targets, {ShiftBy(0, 0, 0.2)});
  const auto lowest_of = [](const ContactStep& step) {
    double least = 1e300;
    int count = 0;
    for (const SeparatingPlane& plane : PlanesOf(step)) {
      ++count;
      EXPECT_NEAR(plane.normal[2], 1, 1e-6);
      least = std::min(least, plane.level);
    }
    EXPECT_GT(count, 0);
    return least;
  };
  // Of the triangle nearest to the bone, which is at z = 0: the gap and half of
  // the room beyond it.
  EXPECT_NEAR(lowest_of(raised) - lowest_of(still), 0.2, kBonePlaneRounding);
}

TEST(FindPlanesOfBones, SeesABoneThatComesFast) {
  // A plate that passes through the whole muscle in one step.
  const ContactGroup group({SphereAt({0, 0, 0}, 5, 2)},
                           {MovedBy(Box(0.2, 30, 30), {-5.4, 0, 0})});
  const ContactStep step = MakeContactStep(
      group.scene, group.state, group.state.targets, {ShiftBy(4, 0, 0)});
  int planes = 0;
  for (const SeparatingPlane& plane : PlanesOf(step)) {
    ++planes;
    EXPECT_GT(plane.normal[0], 0);
  }
  EXPECT_GT(planes, 10);
}

TEST(FindPlanesOfBones, LeavesExemptTrianglesAlone) {
  ContactGroup group = SpheresOverABone();
  const auto of_first = [](const std::vector<SeparatingPlane>& planes) {
    return std::count_if(
        planes.begin(), planes.end(), [](const SeparatingPlane& plane) {
          return plane.muscle_above == 0;
        });
  };
  const auto planes = [&] {
    return PlanesOf(MakeContactStep(group.scene,
                                    group.state,
                                    group.state.targets,
                                    group.state.bones_from_rest));
  };
  EXPECT_GT(of_first(planes()), 0);
  group.scene.muscles[0].exempt = {
      std::vector<char>(group.soups[0].triangles.rows(), true)};
  EXPECT_EQ(of_first(planes()), 0);
}

TEST(FindPlanesOfBones, StayInTheFrameOfTheBone) {
  ContactGroup group = SphereOverAFineBone();
  const PlanesOfStep before = PlanesAtRest(group);
  ASSERT_GT(before.planes.size(), 10u);
  // Everything turns as one.
  Eigen::Isometry3d turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()));
  turn.translation() << 5, 1, 2;
  group.state.bone_planes = before.kept;
  Move(turn.matrix(), &group.state);
  group.state.bones_from_rest = {turn.matrix()};
  const PlanesOfStep after = PlanesAtRest(group);
  ASSERT_EQ(after.planes.size(), before.planes.size());
  for (size_t i = 0; i < after.planes.size(); ++i) {
    EXPECT_LT((after.planes[i].normal.transpose() -
               turn.linear() * before.planes[i].normal.transpose())
                  .norm(),
              1e-12);
  }
  ASSERT_EQ((*after.kept)[0].spaces.size(), (*before.kept)[0].spaces.size());
  for (size_t i = 0; i < (*before.kept)[0].spaces.size(); ++i) {
    EXPECT_EQ((*after.kept)[0].spaces[i].normal,
              (*before.kept)[0].spaces[i].normal);
    EXPECT_EQ((*after.kept)[0].spaces[i].level,
              (*before.kept)[0].spaces[i].level);
  }
}

TEST(FindPlanesOfBones, AreFoundAnewOnceATriangleHasMoved) {
  ContactGroup group = SphereOverAFineBone();
  const PlanesOfStep before = PlanesAtRest(group);
  const double slack = PlaneSearchOptions().kept_slack;
  group.state.bone_planes = before.kept;
  Move(ShiftBy(0.9 * slack, 0, 0), &group.state);
  const PlanesOfStep kept = PlanesAtRest(group);
  // A triangle that comes near may get planes, and none changes those it has.
  for (const SeparatingPlane& plane : before.planes) {
    EXPECT_TRUE(std::any_of(
        kept.planes.begin(), kept.planes.end(), [&](const auto& other) {
          return other.above == plane.above && other.normal == plane.normal &&
                 other.level == plane.level;
        }));
  }
  ExpectAllOfTheBoneBehind(group, kept.planes, Margin());

  group.state.bone_planes = kept.kept;
  Move(ShiftBy(1.2 * slack, 0, 0), &group.state);
  const std::vector<SeparatingPlane> renewed = PlanesAtRest(group).planes;
  ExpectAllOfTheBoneBehind(group, renewed, Margin());
  group.state.bone_planes = nullptr;
  ExpectEqual(renewed, PlanesAtRest(group).planes);
}

// They are not stored with a state. On a rough bone the nearest plane leaves
// out more of what is behind it, whose distance is only bounded.
TEST(FindPlanesOfBones, DoNotDependOnClearances) {
  TriangleSoup rough = SphereAt({0, 0, -20}, 20, 4);
  rough.points += 0.6 * RandomPoints(rough.points.rows(), 1);
  ContactGroup group({SphereAt({0, 0, 11}, 10, 4)}, {rough});
  const Points moves = 0.2 * RandomPoints(40, 2);
  for (Eigen::Index step = 0; step < moves.rows(); ++step) {
    const PlanesOfStep with = PlanesAtRest(group);
    if (group.state.bone_planes != nullptr) {
      auto bare = std::make_shared<KeptBonePlanes>(*group.state.bone_planes);
      for (KeptPlanes& planes : *bare) planes.clearances = {};
      group.state.bone_planes = bare;
      ExpectEqual(with.planes, PlanesAtRest(group).planes);
    }
    group.state.bone_planes = with.kept;
    // To and fro, so that triangles come and go where the bone matters.
    const double sign = step % 2 == 0 ? 1 : -1;
    const Eigen::RowVector3d move =
        moves.row(step) + sign * Eigen::RowVector3d(0, 0, 0.3);
    Move(ShiftBy(move.x(), move.y(), move.z()), &group.state);
  }
}

}  // namespace
}  // namespace musclewarp
