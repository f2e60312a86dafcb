// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/clean_step.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numeric>

#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::RowVector3d;

Matrix4d Shift(const Eigen::Vector3d& by) {
  Matrix4d shift = Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = by;
  return shift;
}

Matrix4d TurnAboutZ(double angle) {
  Matrix4d turn = Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return turn;
}

// Muscles and bones at rest, with nothing that crosses.
struct Group {
  std::vector<TriangleSoup> soups, bone_soups;
  std::vector<ContactMesh> muscles;
  std::vector<std::unique_ptr<TriangleBvh>> trees;
  std::vector<const TriangleBvh*> bones;
  ContactState state;

  Group(std::vector<TriangleSoup> muscle_soups,
        std::vector<TriangleSoup> bones_at_rest)
      : soups(std::move(muscle_soups)), bone_soups(std::move(bones_at_rest)) {
    for (const TriangleSoup& soup : soups) {
      muscles.push_back(
          ContactMesh::Of(soup.points,
                          soup.triangles,
                          SignedVolume(soup.points, soup.triangles)));
      state.points.push_back(soup.points);
    }
    state.targets = state.points;
    for (const TriangleSoup& soup : bone_soups) {
      trees.push_back(
          std::make_unique<TriangleBvh>(soup.points, soup.triangles));
      bones.push_back(trees.back().get());
      state.bones_from_rest.push_back(Matrix4d::Identity());
    }
  }

  CleanStepSummary StepTo(ContactState* next) {
    return StepCleanly({}, muscles, bones, nullptr, next, &state);
  }

  int CrossingPairs() const {
    size_t count = 0;
    for (size_t i = 0; i < soups.size(); ++i) {
      const TriangleBvh mine(state.points[i], soups[i].triangles);
      for (size_t j = i + 1; j < soups.size(); ++j) {
        count += IntersectingTriangles(
                     mine, TriangleBvh(state.points[j], soups[j].triangles))
                     .size();
      }
      for (size_t b = 0; b < bones.size(); ++b) {
        const Points moved =
            Transformed(bone_soups[b].points, state.bones_from_rest[b]);
        count += IntersectingTriangles(
                     mine, TriangleBvh(moved, bone_soups[b].triangles))
                     .size();
      }
    }
    return static_cast<int>(count);
  }

  double VolumeError(size_t muscle) const {
    return SignedVolume(state.points[muscle], soups[muscle].triangles) /
               muscles[muscle].volume -
           1;
  }
};

TriangleSoup SphereAt(const RowVector3d& centre, double radius, int levels) {
  return MovedBy(Icosphere(radius, levels), centre);
}

// A sphere over a bone, and one beside it.
Group SpheresOverABone() {
  return Group(
      {SphereAt({0, 0, 10.5}, 10, 3), SphereAt({20.5, 0, 10.5}, 10, 3)},
      {MovedBy(Box(60, 40, 5), {10, 0, -2.5})});
}

}  // namespace

// The coarse meshes see the planes that vertices have to stay beyond; where
// they bring all vertices then is where the rest of the step takes them.
TEST(CleanStep, AsksTheCoarseMeshesToMakeWay) {
  Group group = SpheresOverABone();
  ContactState next = group.state;
  next.targets[0].rowwise() += RowVector3d(0, 0, -0.8);
  const Points free = next.targets[0];
  std::vector<int> all(free.rows());
  std::iota(all.begin(), all.end(), 0);
  int asked = 0;
  const CoarseContact lift = [&](const ContactRelaxation& relaxation) {
    ++asked;
    double deepest = 0;
    for (const VertexHalfSpace& plane : relaxation.TightestPlanes(0, all)) {
      const RowVector3d& normal = plane.space.normal;
      EXPECT_NEAR(normal.norm(), 1, 1e-12);
      const double depth =
          plane.space.level - normal.dot(free.row(plane.vertex));
      if (depth <= deepest) continue;
      deepest = depth;
      // The bone is below, its upper side at 0, the muscle was at 0.5.
      EXPECT_NEAR(normal[2], 1, 1e-6);
      EXPECT_GT(plane.space.level, 0);
      EXPECT_LT(plane.space.level, 0.5);
    }
    EXPECT_GT(deepest, 0.3);
    std::vector<Points> lifted = next.targets;
    lifted[0].col(2).array() += deepest;
    return lifted;
  };
  CleanStepOptions options;
  options.relaxation.sweeps = 1000;  // until nothing changes
  const CleanStepSummary summary = StepCleanly(
      options, group.muscles, group.bones, lift, &next, &group.state);
  EXPECT_TRUE(summary.is_clean);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(group.CrossingPairs(), 0);
  // Next to nothing is left for single vertices: other planes than the deepest
  // may ask for a little more.
  const Points offset = group.state.points[0] - next.targets[0];
  EXPECT_LT(offset.rowwise().norm().maxCoeff(), 1e-3);
  EXPECT_GT((next.targets[0] - free).rowwise().norm().minCoeff(), 0.3);
}

TEST(CleanStep, GoesToTheTargetsWhereNothingIsInTheWay) {
  Group group = SpheresOverABone();
  ContactState next = group.state;
  next.targets[0].rowwise() += RowVector3d(-0.3, 0.2, 0.4);
  const CleanStepSummary summary = group.StepTo(&next);
  EXPECT_TRUE(summary.is_clean);
  EXPECT_EQ(summary.rounds, 1);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((group.state.points[i] - next.targets[i]).norm(), 1e-11);
  }
}

TEST(CleanStep, RigidMotionStaysRigid) {
  // Pressed to the bone first, then everything turns.
  Group group = SpheresOverABone();
  ContactState pressed = group.state;
  pressed.targets[0].col(2).array() -= 0.8;
  for (int i = 0; i < 40; ++i) {
    ContactState next = pressed;
    ASSERT_TRUE(group.StepTo(&next).is_clean);
  }
  const ContactState before = group.state;
  const Matrix4d turn = TurnAboutZ(0.02);
  ContactState next = before;
  for (int i = 0; i < 2; ++i) {
    next.targets[i] = Transformed(before.targets[i], turn);
  }
  next.bones_from_rest[0] = turn;
  ASSERT_TRUE(group.StepTo(&next).is_clean);
  for (int i = 0; i < 2; ++i) {
    // The offsets are some tenths of a mm and go on to settle.
    EXPECT_LT((group.state.points[i] - Transformed(before.points[i], turn))
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              0.02);
  }
}

TEST(CleanStep, KeepsVolumeAndDistanceUnderPressure) {
  Group group = SpheresOverABone();
  for (int step = 1; step <= 10; ++step) {
    // Into the bone and into each other.
    ContactState next = group.state;
    next.targets[0] = group.soups[0].points.rowwise() +
                      RowVector3d(0.1 * step, 0, -0.3 * step);
    next.targets[1] = group.soups[1].points.rowwise() +
                      RowVector3d(-0.1 * step, 0, -0.1 * step);
    const CleanStepSummary summary = group.StepTo(&next);
    ASSERT_TRUE(summary.is_clean) << step;
    EXPECT_EQ(group.CrossingPairs(), 0);
    for (int i = 0; i < 2; ++i) {
      EXPECT_GT(group.state.points[i].col(2).minCoeff(), 0);
      // RelaxationOptions::volume_tolerance.
      EXPECT_NEAR(group.VolumeError(i), 0, 2e-8);
    }
  }
  // Contact is worth no more than what would overlap, by far.
  const Points moves = group.state.points[0] - group.state.targets[0];
  EXPECT_LT(moves.rowwise().norm().maxCoeff(), 3.5);
  EXPECT_GT(moves.rowwise().norm().maxCoeff(), 2);
}

TEST(CleanStep, GoesBackWhenNothingPressesAnyMore) {
  Group group = SpheresOverABone();
  for (const double down : {0.5, 1.0, 0.5, 0.0}) {
    ContactState next = group.state;
    next.targets[0] =
        group.soups[0].points.rowwise() + RowVector3d(0, 0, -down);
    ASSERT_TRUE(group.StepTo(&next).is_clean);
  }
  for (int i = 0; i < 60; ++i) {
    ContactState next = group.state;
    ASSERT_TRUE(group.StepTo(&next).is_clean);
  }
  EXPECT_LT((group.state.points[0] - group.soups[0].points)
                .rowwise()
                .norm()
                .maxCoeff(),
            1e-3);
}

TEST(CleanStep, ABoneDoesNotPassThroughAMuscle) {
  // A thin plate comes from the side by far more than its thickness.
  Group group({SphereAt({0, 0, 0}, 10, 3)},
              {MovedBy(Box(0.2, 60, 60), {-10.4, 0, 0})});
  for (int step = 1; step <= 12; ++step) {
    ContactState next = group.state;
    next.bones_from_rest[0] = Shift({0.5 * step, 0, 0});
    ASSERT_TRUE(group.StepTo(&next).is_clean) << step;
    EXPECT_EQ(group.CrossingPairs(), 0);
    EXPECT_GT(group.state.points[0].col(0).minCoeff(), -10.3 + 0.5 * step);
  }
}

TEST(CleanStep, WhereThereIsNoRoomItSaysSoAndLeavesTheState) {
  // Two plates that close to nothing.
  Group group({SphereAt({0, 0, 0}, 10, 2)},
              {MovedBy(Box(60, 60, 1), {0, 0, 10.7}),
               MovedBy(Box(60, 60, 1), {0, 0, -10.7})});
  ContactState next = group.state;
  next.bones_from_rest[0] = Shift({0, 0, -20.6});
  const ContactState before = group.state;
  const CleanStepSummary summary = group.StepTo(&next);
  EXPECT_FALSE(summary.is_clean);
  EXPECT_GT(summary.crossing_pairs, 0);
  EXPECT_EQ(group.state.points[0], before.points[0]);
  EXPECT_EQ(group.state.bones_from_rest[0], before.bones_from_rest[0]);
}

TEST(CleanStep, DoesNotDependOnTheOrderOfMuscles) {
  const TriangleSoup a = SphereAt({0, 0, 10.5}, 10, 3);
  const TriangleSoup b = SphereAt({20.5, 0, 10.5}, 10, 3);
  const TriangleSoup c = SphereAt({10, 18.5, 10.5}, 10, 4);
  const TriangleSoup bone = MovedBy(Box(80, 80, 5), {10, 10, -2.5});
  Group one({a, b, c}, {bone});
  Group two({c, a, b}, {bone});
  ASSERT_EQ(one.CrossingPairs(), 0);
  for (int step = 0; step < 3; ++step) {
    ContactState next_one = one.state, next_two = two.state;
    for (int i = 0; i < 3; ++i) {
      const RowVector3d move(i == 0 ? 0.5 : -0.3, -0.2 * i, -0.4);
      next_one.targets[i].rowwise() += move;
      next_two.targets[(i + 1) % 3].rowwise() += move;
    }
    ASSERT_TRUE(one.StepTo(&next_one).is_clean);
    ASSERT_TRUE(two.StepTo(&next_two).is_clean);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT((one.state.points[i] - two.state.points[(i + 1) % 3])
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              1e-6);
  }
}

TEST(CleanStep, RefusesOptionsThatMakeNoSense) {
  std::string error;
  CleanStepOptions options;
  EXPECT_TRUE(options.IsValid(&error));
  options.relaxation.reach = 0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("reach"), std::string::npos);
  options = {};
  options.max_rounds = 0;
  EXPECT_FALSE(options.IsValid(&error));
}

}  // namespace musclewarp
