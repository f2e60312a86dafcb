// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/phantom_scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// File contents by name.
std::map<std::string, std::string> FilesIn(const std::string& dir) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(dir)) {
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    files[entry.path().filename().string()] = text.str();
  }
  return files;
}

// A scene of one ball each, quick to make.
PhantomScene BallScene() {
  PhantomScene small;
  small.scene.name = "small";
  SceneMuscle muscle;
  muscle.name = "ball";
  muscle.mesh_path = "ball.ply";
  ActionLine line;
  line.name = "through";
  line.rest.resize(2, 3);
  line.rest << 0, 0, -1.5, 0, 0, 0.1;
  line.bodies = {"ground", "ground"};
  muscle.lines = {line};
  Attachment attachment;
  attachment.body = "ground";
  attachment.points = line.rest.topRows(1);
  attachment.radius = 0.5;
  muscle.attachments = {attachment};
  small.scene.muscles = {muscle};
  small.scene.bones = {{"floor", {}, {}, "ground", "floor.ply"}};
  ScenePose pose;
  pose.name = "up";
  pose.time = 0.25;
  pose.bodies["ground"] = Eigen::Matrix4d::Identity();
  pose.bodies["ground"](2, 3) = 10;
  pose.lines["through"] = line.rest;
  small.scene.poses = {pose};
  small.meshes = {{"ball", Icosphere(2, 1), {}, Icosphere(2, 1)},
                  {"floor", Box(9, 9, 1), {}, Box(9, 9, 1)}};
  return small;
}

TEST(WritePhantomScene, WhatIsWrittenReadsBack) {
  const PhantomScene small = BallScene();
  const std::string dir = TestTempDir() + "/new/folder";
  WritePhantomScene(small, dir);
  const Scene scene = ReadScene(dir + "/scene.json", "");
  EXPECT_EQ(scene.name, "small");
  ASSERT_EQ(scene.muscles.size(), 1u);
  EXPECT_EQ(scene.muscles[0].lines[0].rest,
            small.scene.muscles[0].lines[0].rest);
  EXPECT_EQ(scene.muscles[0].lines[0].bodies,
            small.scene.muscles[0].lines[0].bodies);
  EXPECT_EQ(scene.muscles[0].attachments[0].points,
            small.scene.muscles[0].attachments[0].points);
  EXPECT_EQ(scene.muscles[0].attachments[0].radius, 0.5);
  ASSERT_EQ(scene.poses.size(), 1u);
  EXPECT_EQ(scene.poses[0].time, 0.25);
  EXPECT_EQ(scene.poses[0].bodies, small.scene.poses[0].bodies);
  EXPECT_EQ(scene.poses[0].lines, small.scene.poses[0].lines);
  EXPECT_EQ(ReadTriangleSoup(scene.muscles[0].mesh_path).points,
            small.meshes[0].delivered.points);
  EXPECT_EQ(ReadTriangleSoup(scene.bones[0].mesh_path).triangles,
            small.meshes[1].delivered.triangles);
}

TEST(WritePhantomScene, AFolderThatCannotBeMadeIsAnError) {
  const std::string dir = TestTempDir();
  std::ofstream(dir + "/file") << "in the way";
  EXPECT_THROW(WritePhantomScene(BallScene(), dir + "/file/scene"), InputError);
}

// data/phantom is what the program makes: "musclewarp-phantom
// --out=data/phantom" writes it anew after a change.
TEST(WritePhantomScene, TheEmbeddedSceneIsWhatIsMade) {
  const std::string dir = TestTempDir();
  WritePhantomScene(MakePhantomScene("hip", 1), dir);
  const auto made = FilesIn(dir);
  auto embedded = FilesIn(MUSCLEWARP_EMBEDDED_DATA "/phantom");
  embedded.erase("README.md");
  ASSERT_EQ(made.size(), embedded.size());
  size_t bytes = 0;
  for (const auto& [name, contents] : made) {
    ASSERT_TRUE(embedded.count(name)) << name;
    // Not EXPECT_EQ: it would print the bytes.
    EXPECT_TRUE(contents == embedded[name]) << name << " differs";
    bytes += contents.size();
  }
  EXPECT_LT(bytes, 1.5 * 1024 * 1024);
  EXPECT_NO_THROW(ReadScene(dir + "/scene.json", ""));
}

}  // namespace
}  // namespace musclewarp
