// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/delivered_crossings.h"

#include <gtest/gtest.h>

#include <vector>

#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A muscle beside two bones, which have lost some triangles.
struct Muscles {
  SearchableMesh psoas{SphereAt({0, 0, 0}, 10, 3)};
  SearchableMesh iliacus{SphereAt({50, 0, 0}, 10, 3)};
  std::vector<NamedMesh> muscles = {{"psoas", &psoas}, {"iliacus", &iliacus}};
};

TEST(CrossingsWithDelivered, ThereAreNoneOfBonesThatAreAsDelivered) {
  const Muscles scene;
  EXPECT_TRUE(
      CrossingsWithDelivered(scene.muscles, {{"femur", {}}, {"pelvis", {}}})
          .empty());
}

TEST(CrossingsWithDelivered, CountsThePairsOfTheMeshItself) {
  const Muscles scene;
  const TriangleSoup lost = SphereAt({9, 0, 0}, 4, 2);
  const auto crossings =
      CrossingsWithDelivered(scene.muscles, {{"femur", {}}, {"foot", lost}});
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].muscle, "psoas");
  EXPECT_EQ(crossings[0].bone, "foot");
  EXPECT_EQ(crossings[0].pieces_inside, 0);
  EXPECT_EQ(crossings[0].triangle_pairs,
            static_cast<int>(IntersectMeshes(scene.psoas, SearchableMesh(lost))
                                 .triangle_pairs.size()));
  // Where two spheres around places 9 mm apart meet.
  EXPECT_NEAR(crossings[0].place.x(), (100 - 16 + 81) / 18.0, 0.5);
}

TEST(CrossingsWithDelivered, APieceWithinAMuscleCounts) {
  const Muscles scene;
  const TriangleSoup lost =
      Together(SphereAt({51, 0, 0}, 1, 1), SphereAt({30, 0, 0}, 1, 1));
  const auto crossings =
      CrossingsWithDelivered(scene.muscles, {{"foot", lost}});
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].muscle, "iliacus");
  EXPECT_EQ(crossings[0].triangle_pairs, 0);
  EXPECT_EQ(crossings[0].pieces_inside, 1);
}

TEST(CrossingsWithDelivered, ExemptTrianglesDoNotCount) {
  const Muscles scene;
  ExemptArea area;
  area.muscle = 0;
  area.bone = 0;
  area.vertices.assign(scene.psoas.points().rows(), true);
  area.triangles.assign(scene.psoas.triangles().rows(), true);
  const TriangleSoup lost = SphereAt({9, 0, 0}, 4, 2);
  EXPECT_TRUE(
      CrossingsWithDelivered(scene.muscles, {{"foot", lost}}, {area}).empty());
}

}  // namespace
}  // namespace musclewarp
