// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Returns the path of a file that states a space.
std::string FileInSpace(const std::string& dir,
                        const std::string& name,
                        const std::string& space) {
  WriteTextAtomically(dir + "/" + name + ".obj",
                      "# SPACE=" + space +
                          "\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                          "f 1 2 3\n");
  return dir + "/" + name + ".obj";
}

// A muscle in RAS and a bone in LPS.
Scene MixedScene() {
  const std::string dir = TestTempDir();
  Scene scene;
  scene.muscles.resize(1);
  scene.muscles[0].mesh_path = FileInSpace(dir, "muscle", "RAS");
  scene.bones.resize(1);
  scene.bones[0].mesh_path = FileInSpace(dir, "bone", "LPS");
  return scene;
}

TEST(BringIntoOneSpace, TurnsWhatDiffersFromTheFirst) {
  Scene scene = MixedScene();
  // Marks are the same when a scene is put together again.
  for (int i = 0; i < 2; ++i) {
    BringIntoOneSpace(&scene);
    EXPECT_FALSE(scene.muscles[0].is_turned);
    EXPECT_TRUE(scene.bones[0].is_turned);
    EXPECT_THAT(scene.warnings,
                ElementsAre(AllOf(HasSubstr("bone.obj states the space LPS"),
                                  HasSubstr("muscle.obj RAS"))));
  }
}

TEST(BringIntoOneSpace, StatedAxesDecide) {
  Scene scene = MixedScene();
  scene.states_axes = true;
  BringIntoOneSpace(&scene);
  EXPECT_TRUE(scene.muscles[0].is_turned);
  EXPECT_FALSE(scene.bones[0].is_turned);
}

TEST(BringIntoOneSpace, AxesThatAreNotStatedAreThoseOfTheFiles) {
  Scene scene = MixedScene();
  scene.bones.clear();
  ASSERT_EQ(scene.axes, "LPS");
  scene.states_axes = true;
  BringIntoOneSpace(&scene);
  EXPECT_EQ(scene.axes, "LPS");
  scene.states_axes = false;
  BringIntoOneSpace(&scene);
  EXPECT_EQ(scene.axes, "RAS");
  EXPECT_FALSE(scene.muscles[0].is_turned);
  EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("axes: RAS")));
}

TEST(BringIntoOneSpace, LeavesBonesThatAModelPlaces) {
  Scene scene = MixedScene();
  scene.bones[0].rest_from_file(0, 3) = 100;
  BringIntoOneSpace(&scene);
  EXPECT_FALSE(scene.muscles[0].is_turned);
  EXPECT_FALSE(scene.bones[0].is_turned);
  EXPECT_THAT(scene.warnings, ElementsAre());
  // A unit is no place.
  scene.bones[0].rest_from_file.setIdentity();
  scene.bones[0].rest_from_file.diagonal().head<3>().setConstant(10);
  BringIntoOneSpace(&scene);
  EXPECT_TRUE(scene.bones[0].is_turned);
}

TEST(BringIntoOneSpace, IsDoneForSceneFiles) {
  const Scene mixed = MixedScene();
  const auto read = [&](const std::string& axes) {
    const std::string path = TestTempPath() + "/scene.json";
    WriteTextAtomically(path,
                        R"({"name": "s", "units": "mm",)" + axes +
                            R"("muscles": [{"name": "m", "mesh": "muscle.obj"}],
                "bones": [{"name": "b", "mesh": "bone.obj", "body": "b"}],
                "poses": [{"name": "p", "bodies": {}}]})");
    return ReadScene(path, "");
  };
  EXPECT_FALSE(read("").muscles[0].is_turned);
  EXPECT_TRUE(read("").bones[0].is_turned);
  EXPECT_TRUE(read(R"("axes": "LPS",)").muscles[0].is_turned);
  EXPECT_FALSE(read(R"("axes": "LPS",)").bones[0].is_turned);
}

}  // namespace
}  // namespace musclewarp
