// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/prepared_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/obj_io.h"
#include "support/input_errors.h"
#include "support/meshes.h"
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
    EXPECT_EQ(a.fine_from_coarse.weights, b.fine_from_coarse.weights);
    EXPECT_EQ(a.fine_from_coarse.corrections, b.fine_from_coarse.corrections);
  }
}

// Both muscles of the small scene are objects of one file.
TEST(PrepareScene, TakesAnObjectOfAFileAndRefusesToLoseOne) {
  const PreparedScene from_memory = PreparedSmallScene();
  Scene scene = SmallScene();
  const std::string file = TestTempDir() + "/muscles.obj";
  const Eigen::Index first = scene.muscles[0].triangles.rows();
  std::istringstream lines(ObjBytes(
      Together({scene.muscles[0].points, scene.muscles[0].triangles},
               {scene.muscles[1].points, scene.muscles[1].triangles})));
  std::string text;
  Eigen::Index faces = 0;
  for (std::string line; std::getline(lines, line); text += line + "\n") {
    if (line[0] != 'f') continue;
    if (faces == 0) text += "o " + scene.muscles[0].name + "\n";
    if (faces == first) text += "o " + scene.muscles[1].name + "\n";
    ++faces;
  }
  WriteTextAtomically(file, text);
  for (SceneMuscle& muscle : scene.muscles) {
    muscle.mesh_path = file + "#" + muscle.name;
    muscle.points.resize(0, 3);
    muscle.triangles.resize(0, 3);
  }
  const PreparedScene prepared = PreparedSmallScene(scene);
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    EXPECT_EQ(prepared.muscles[i].model.fine_rest,
              from_memory.muscles[i].model.fine_rest);
    EXPECT_EQ(prepared.muscles[i].mesh.path, scene.muscles[i].mesh_path);
  }

  scene.muscles[1].mesh_path = file;
  ExpectInputError([&] { PreparedSmallScene(scene); },
                   {"muscles.obj: has 2 objects: " + scene.muscles[0].name +
                    ", " + scene.muscles[1].name});
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

// A muscle from a pelvis at z = 200 that ends on a tendon with a mesh of its
// own, which goes on to a foot at z = 0.
Scene SceneWithTendon() {
  Scene scene;
  const auto add_muscle = [&](const char* name, const TriangleSoup& mesh) {
    scene.muscles.push_back({name, mesh.points, mesh.triangles});
  };
  const auto add_bone = [&](const char* name, const TriangleSoup& mesh) {
    scene.bones.push_back({name, mesh.points, mesh.triangles, name});
  };
  add_muscle("belly", MovedBy(Spindle(15, 60, 4), {0, 0, 140}));
  add_muscle("tendon", MovedBy(Spindle(3, 45, 4), {0, 0, 45}));
  add_bone("pelvis", SphereAt({0, 0, 212}, 12, 3));
  add_bone("foot", SphereAt({0, 0, -12}, 12, 3));
  return scene;
}

TEST(PrepareScene, ATendonWithAMeshOfItsOwnKeepsItsLength) {
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  options.auto_lines = 1;
  const PreparedScene prepared = PrepareScene(SceneWithTendon(), options);
  EXPECT_EQ(prepared.muscles[0].lines_through, std::vector<int>{1});
  EXPECT_EQ(prepared.muscles[1].lines_through, std::vector<int>{0});
  // Where they meet no body holds them, and the thinner one carries the other.
  const MuscleModel& belly = prepared.muscles[0].model;
  ASSERT_EQ(belly.attachments.size(), 2u);
  EXPECT_EQ(belly.attachments[0].body, "pelvis");
  EXPECT_EQ(belly.attachments[1].soft_part, "tendon");
  EXPECT_LT(belly.attachments[1].points.col(2).maxCoeff(), 95);
  EXPECT_EQ(belly.carriers.count(1), 1u);
  const MuscleModel& tendon = prepared.muscles[1].model;
  ASSERT_EQ(tendon.attachments.size(), 1u);
  EXPECT_EQ(tendon.attachments[0].body, "foot");
  const ScenePose rest;
  ScenePose lowered;
  lowered.bodies["foot"] = Eigen::Matrix4d::Identity();
  lowered.bodies["foot"](2, 3) = -10;
  std::vector<double> stretches;
  for (const PreparedMuscle& muscle : prepared.muscles) {
    stretches.push_back(
        CarriedLength(muscle, lowered) / CarriedLength(muscle, rest) - 1);
  }
  // Both together are stretched by 10 of 210 mm, the tendon by less.
  EXPECT_GT(stretches[0], 10.0 / 210);
  EXPECT_LT(stretches[1], 0.75 * 10 / 210);
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
  EXPECT_LE(done.back(), 6);
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
