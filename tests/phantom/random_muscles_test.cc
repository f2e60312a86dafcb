// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_muscles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "musclewarp/phantom/scene_parts.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

// How much deeper than drawn meshes may be in each other, mm: bumps of 0.3 mm
// on both sides, the rounding of the cut, and facets.
constexpr double kRoughness = 1.2;

// Two rods end to end, 300 mm long together, and a first muscle on them.
class DrawnMuscles : public ::testing::Test {
 protected:
  DrawnMuscles() : draws_(7) {
    for (const int i : {0, 1}) {
      const Vector3d start(0, 0, 155.0 * i), end(0, 0, 155.0 * i + 145);
      RandomBone bone;
      bone.name = i == 0 ? "upper" : "lower";
      bone.parent = i - 1;
      bone.thickness = bone.breadth = 24;
      bone.field = Sweep({{start, 12}, {end, 12}});
      bone.mesh =
          MeshOf({bone.name,
                  bone.field,
                  {start - Vector3d(20, 20, 20), end + Vector3d(20, 20, 20)},
                  4,
                  {}},
                 i);
      bones_.push_back(bone);
    }
  }

  // Draws until `count` muscles are there.
  void Draw(size_t count) {
    for (int i = 0; i < 300 && muscles_.size() < count; ++i) {
      std::optional<RandomMuscle> muscle =
          DrawMuscle("muscle", bones_, muscles_, 0.5, &draws_);
      if (muscle) muscles_.push_back(*muscle);
    }
    ASSERT_EQ(muscles_.size(), count);
  }

  RandomDraws draws_;
  std::vector<RandomBone> bones_;
  std::vector<RandomMuscle> muscles_;
};

TEST_F(DrawnMuscles, RunFromOneBoneToTheOther) {
  Draw(3);
  for (const RandomMuscle& muscle : muscles_) {
    EXPECT_NE(muscle.ends[0].bone, muscle.ends[1].bone);
    for (const MuscleEnd& end : muscle.ends) {
      // The site is a vertex, the bumps are 0.25 mm high.
      EXPECT_NEAR(bones_[end.bone].field(end.site), 0, 0.3);
    }
    for (const ActionLine& line : muscle.lines) {
      EXPECT_EQ(line.bodies.front(), bones_[muscle.ends[0].bone].name);
      EXPECT_EQ(line.bodies.back(), bones_[muscle.ends[1].bone].name);
      EXPECT_EQ(static_cast<Eigen::Index>(line.bodies.size()),
                line.rest.rows());
    }
  }
}

TEST_F(DrawnMuscles, AreNoDeeperInTheirNeighboursThanAThirdOfTheThinner) {
  Draw(4);
  int touching = 0;
  for (size_t i = 0; i < muscles_.size(); ++i) {
    const SearchableMesh mesh(muscles_[i].mesh.surface);
    const auto check = [&](const PhantomMesh& other, double thickness) {
      const MeshIntersection found =
          IntersectMeshes(mesh, SearchableMesh(other.surface));
      EXPECT_LE(found.max_depth_mm,
                0.33 * std::min(thickness, muscles_[i].thickness) + kRoughness)
          << i << " in " << other.name;
      touching += !found.IsEmpty();
    };
    for (const RandomBone& bone : bones_) check(bone.mesh, bone.thickness);
    for (size_t j = 0; j < i; ++j) {
      check(muscles_[j].mesh, muscles_[j].thickness);
    }
  }
  EXPECT_GE(touching, 4);
}

TEST_F(DrawnMuscles, AreNotDrawnWhereThereIsNoRoom) {
  // The space around the rods is full.
  RandomMuscle all;
  all.ends = {MuscleEnd{0, {12, 0, 70}, {1, 0, 0}},
              MuscleEnd{1, {12, 0, 220}, {1, 0, 0}}};
  all.strap = Sphere({0, 0, 150}, 1000);
  all.box = {Vector3d::Constant(-900), Vector3d::Constant(1100)};
  all.thickness = 2000;
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(DrawMuscle("muscle", bones_, {all}, 1, &draws_));
  }
}

}  // namespace
}  // namespace musclewarp::phantom
