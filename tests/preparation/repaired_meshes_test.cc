// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/repaired_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// The small scene with half a skull, which no repair closes.
Scene WithHalfASkull(bool is_of_model) {
  Scene scene = SmallScene();
  TriangleSoup skull = MovedBy(Icosphere(80, 3), {0, 300, 0});
  skull.triangles.conservativeResize(skull.triangles.rows() / 2, 3);
  SceneBone bone;
  bone.name = bone.body = "skull";
  bone.points = skull.points;
  bone.triangles = skull.triangles;
  bone.is_of_model = is_of_model;
  scene.bones.insert(scene.bones.begin(), bone);
  for (SceneBone& each : scene.bones) each.body = each.name;
  return scene;
}

TEST(RepairBone, AMeshThatAModelShowsIsLeftOutIfItIsNoClosedSurface) {
  const PreparedScene prepared = PrepareScene(WithHalfASkull(true), {});
  ASSERT_EQ(prepared.bones.size(), 2u);
  ASSERT_EQ(prepared.scene.bones.size(), 2u);
  EXPECT_EQ(prepared.bones[0].mesh.name, prepared.scene.bones[0].name);
  EXPECT_THAT(
      prepared.warnings,
      Contains(HasSubstr("skull: a mesh that the model shows is left out")));
}

TEST(RepairBone, AMeshThatWasAskedForIsNot) {
  ExpectInputError([] { PrepareScene(WithHalfASkull(false), {}); },
                   {"skull", "open border"});
}

}  // namespace
}  // namespace musclewarp
