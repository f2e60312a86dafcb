// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/prepared_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/prepared_small_scene.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

TEST(PrepareScene, TakesAMeshFromMemoryAsFromAFile) {
  const PreparedScene from_memory = PreparedSmallScene();
  Scene scene = SmallScene();
  const std::string dir = TestTempDir();
  for (SceneMuscle& muscle : scene.muscles) {
    muscle.mesh_path = dir + "/" + muscle.name + ".ply";
    WriteTriangleSoup(muscle.mesh_path, {muscle.points, muscle.triangles});
    muscle.points.resize(0, 3);
    muscle.triangles.resize(0, 3);
  }
  const PreparedScene from_files = PreparedSmallScene(scene);
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& a = from_memory.muscles[i].model;
    const MuscleModel& b = from_files.muscles[i].model;
    EXPECT_EQ(a.fine_rest, b.fine_rest);
    EXPECT_EQ(a.coarse_rest, b.coarse_rest);
    EXPECT_EQ(a.fine_from_coarse, b.fine_from_coarse);
  }
}

TEST(PrepareScene, NamesAMeshInMemoryThatCannotBeRepaired) {
  Scene scene = SmallScene();
  scene.muscles[1].triangles.conservativeResize(100, 3);  // a large hole
  try {
    PreparedSmallScene(scene);
    FAIL() << "an open mesh was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("right"));
  }
}

TEST(PrepareScene, MakesLinesForAMuscleThatHasNone) {
  Scene scene = SmallScene();
  scene.muscles[0].lines.clear();
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  options.auto_lines = 2;
  const PreparedScene prepared = PrepareScene(scene, options);
  EXPECT_EQ(prepared.scene.muscles[0].lines.size(), 2u);
  EXPECT_EQ(prepared.scene.muscles[1].lines.size(), 1u);
}

TEST(PrepareScene, WarnsOfMeshesInOtherUnits) {
  Scene scene = SmallScene();
  scene.bones[0].points /= 1000;  // in metres
  const PreparedScene prepared = PreparedSmallScene(scene);
  ASSERT_FALSE(prepared.warnings.empty());
  EXPECT_THAT(prepared.warnings[0], HasSubstr("pelvis"));
}

TEST(PrepareScene, SaysHowFarItIs) {
  std::vector<int> done;
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  PrepareScene(SmallScene(), options, [&](const Progress& progress) {
    EXPECT_EQ(progress.total, 6);  // four meshes are read, two prepared
    done.push_back(progress.done);
  });
  // Meshes are prepared several at a time, and progress is said in between.
  ASSERT_FALSE(done.empty());
  EXPECT_EQ(done.front(), 0);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_LT(done.back(), 6);
}

TEST(PrepareOptions, NameWhatIsWrong) {
  PrepareOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.auto_lines = 0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("auto_lines is 0"));
}

}  // namespace
}  // namespace musclewarp
