// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/bone_overlaps.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// A box, one whose corner is 0.75 mm deep in it, and one apart from both.
struct Boxes {
  SearchableMesh pelvis{LatticeBox(4, 4, 4)};
  SearchableMesh femur{MovedBy(LatticeBox(4, 4, 4), {3.25, 0.5, 0.5})};
  SearchableMesh tibia{MovedBy(LatticeBox(4, 4, 4), {20, 0, 0})};
  std::vector<NamedMesh> bones = {
      {"pelvis", &pelvis}, {"femur", &femur}, {"tibia", &tibia}};
};

TEST(BoneOverlaps, FindsAKnownDepthInEitherOrder) {
  const Boxes boxes;
  const std::vector<BoneOverlap> found =
      BoneOverlaps(boxes.bones, {"pelvis", "femur_r", "tibia_r"});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].a, "pelvis");
  EXPECT_EQ(found[0].b, "femur");
  // All coordinates are exact in floating point.
  EXPECT_EQ(found[0].depth_mm, 0.75);
  EXPECT_EQ(found[0].place.x(), 4);

  const std::vector<BoneOverlap> reversed =
      BoneOverlaps({boxes.bones.rbegin(), boxes.bones.rend()},
                   {"tibia_r", "femur_r", "pelvis"});
  ASSERT_EQ(reversed.size(), 1u);
  EXPECT_EQ(reversed[0].a, "femur");
  EXPECT_EQ(reversed[0].depth_mm, 0.75);
  EXPECT_EQ(reversed[0].place.x(), 3.25);
}

TEST(BoneOverlaps, BonesOfOneBodyDoNotCount) {
  const Boxes boxes;
  EXPECT_TRUE(
      BoneOverlaps(boxes.bones, {"pelvis", "pelvis", "tibia_r"}).empty());
}

TEST(BoneOverlaps, ABoneInsideAnotherCounts) {
  const SearchableMesh ball(Icosphere(10, 3));
  const SearchableMesh core(Icosphere(2, 1));
  const std::vector<BoneOverlap> found =
      BoneOverlaps({{"ball", &ball}, {"core", &core}}, {"a", "b"});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].depth_mm, 7);  // 8 to the sphere, less to its triangles
}

}  // namespace
}  // namespace musclewarp
