// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/render_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/stl_io.h"
#include "musclewarp/render/picture.h"
#include "musclewarp/render/stretch_colors.h"
#include "musclewarp/run/bones_file.h"
#include "musclewarp/run/run_files.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Key;

// A run of three frames: a muscle that moves away, and a bone.
std::string WriteRun() {
  const std::string dir = TestTempDir();
  for (int i = 0; i < 3; ++i) {
    const std::string frame = dir + "/frame_000" + std::to_string(i);
    fs::create_directories(frame);
    TriangleSoup muscle = Spindle(10, 50, 2);
    muscle.points.col(0).array() += 20 * i;
    WriteTriangleSoup(frame + "/psoas_major.ply", muscle);
    WriteTriangleSoup(frame + "/femur.ply", Box(10, 10, 120));
  }
  std::vector<FrameFigures> frames(2);
  frames[0].index = 0;
  frames[0].name = "rest";
  frames[1].index = 2;
  frames[1].name = "flexion_60";
  const nlohmann::ordered_json report = {
      {"scene", "thigh"},
      {"version", kVersion},
      {"axes", "LPS"},
      {"inputs_hash", "0123"},
      {"contact", "none"},
      {"prepare",
       {{"muscles", {{{"name", "psoas_major"}}}},
        {"bones", {{{"name", "femur"}}}}}},
      {"frames", JsonOf(frames)},
      {"summary", {{"finished", true}, {"usable", true}}}};
  WriteTextAtomically(dir + "/report.json", report.dump());
  return dir;
}

std::string RenderError(const RenderRequest& request) {
  std::ostringstream log;
  try {
    Render(request, log);
  } catch (const InputError& error) {
    EXPECT_FALSE(fs::exists(request.out));
    return error.WithFlags();
  }
  return "no error";
}

bool CanDraw() {
  PicturePanel panel;
  panel.meshes.push_back({Box(1, 1, 1), {}, 1, true, {}});
  PictureOptions options;
  options.width = options.height = 16;
  try {
    DrawPicture(
        {panel}, {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()}, options);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

std::string Bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(RunFiles, FramesComeInTheirOrderWithTheNamesOfTheReport) {
  const std::string dir = WriteRun();
  const RunFiles run = FindRunFiles(dir, "last,0,1");
  ASSERT_EQ(run.frames.size(), 3u);
  EXPECT_EQ(run.frames[0].name, "flexion_60");
  EXPECT_EQ(run.frames[1].name, "rest");
  EXPECT_EQ(run.frames[2].name, "");
  EXPECT_THAT(run.frames[0].meshes,
              ElementsAre(Key("femur"), Key("psoas_major")));
  EXPECT_EQ(run.frames[0].meshes.at("femur"), dir + "/frame_0002/femur.ply");
  EXPECT_TRUE(run.has_report);
  EXPECT_THAT(run.muscles, ElementsAre("psoas_major"));
}

TEST(RunFiles, AFolderOfMeshesIsOneFrame) {
  const std::string dir = WriteRun() + "/frame_0001";
  const RunFiles run = FindRunFiles(dir, "0");
  ASSERT_EQ(run.frames.size(), 1u);
  EXPECT_EQ(run.frames[0].meshes.size(), 2u);
  EXPECT_FALSE(run.has_report);
}

TEST(RunFiles, OfSeveralFormatsTheMostExactIsTaken) {
  const std::string dir = TestTempDir();
  for (const char* name : {"/a.stl", "/a.ply", "/a.obj", "/b.stl", "/b.off"}) {
    WriteTriangleSoup(dir + name, UnitTetrahedron());
  }
  WriteTextAtomically(dir + "/notes.txt", "not a mesh");
  const MeshFiles files = MeshFilesIn(dir);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files.at("a"), dir + "/a.ply");
  EXPECT_EQ(files.at("b"), dir + "/b.off");
}

TEST(RenderCommand, DrawsFramesSideBySide) {
  if (!CanDraw()) GTEST_SKIP() << "no OpenGL";
  RenderRequest request;
  request.in = WriteRun();
  request.out = request.in + "/a.png";
  request.frames = "0,last";
  request.size = "300x200";
  request.fade = "femur:0.5";
  std::ostringstream log;
  Render(request, log);
  EXPECT_THAT(log.str(), HasSubstr(request.out));
  const std::string both = Bytes(request.out);
  // Width and height in the header of a PNG file.
  EXPECT_EQ(both.substr(16, 8), std::string("\0\0\1\x2c\0\0\0\xc8", 8));
  Render(request, log);
  EXPECT_EQ(Bytes(request.out), both);
}

TEST(RenderCommand, DrawsBonesThatAreWrittenOnceWhereTheyAreInTheFrame) {
  if (!CanDraw()) GTEST_SKIP() << "no OpenGL";
  RenderRequest request;
  request.in = WriteRun();
  request.out = request.in + "/a.png";
  request.frames = "2";
  request.size = "300x200";
  std::ostringstream log;
  const std::string bone = request.in + "/frame_0002/femur.ply";
  const TriangleSoup rest = ReadTriangleSoup(bone);
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion(1, 3) = 80;
  WriteTriangleSoup(bone, {Transformed(rest.points, motion), rest.triangles});
  Render(request, log);
  const std::string every = Bytes(request.out);
  fs::remove(bone);
  fs::create_directories(request.in + "/rest");
  WriteTriangleSoup(request.in + "/rest/femur.ply", rest);
  WriteBonesFile(request.in + "/frame_0002/bones.json", {{"femur", motion}});
  Render(request, log);
  EXPECT_TRUE(Bytes(request.out) == every);
}

TEST(RenderCommand, ColoursByStretchNeedTheMeshesAtRest) {
  RenderRequest request;
  request.in = WriteRun();
  request.out = request.in + "/picture.png";
  request.color = "stretch";
  EXPECT_THAT(RenderError(request), HasSubstr("rest"));
  fs::create_directories(request.in + "/rest");
  TriangleSoup muscle = Spindle(10, 50, 1);
  WriteTriangleSoup(request.in + "/rest/psoas_major.ply", muscle);
  EXPECT_THAT(RenderError(request), HasSubstr("other triangles"));
  request.color = "volume";
  EXPECT_THAT(RenderError(request), HasSubstr("allowed: muscle, stretch"));
}

TEST(StretchColors, DarkenWithStretch) {
  const TriangleSoup box = Box(1, 1, 1);
  int before = 256;
  for (const double stretch : {1.0, 1.3, 1.5, 1.8, 2.1}) {
    const Color color =
        StretchColors(box.points, stretch * box.points, box.triangles).front();
    EXPECT_LT(color.g, before) << stretch;
    before = color.g;
  }
}

TEST(RenderCommand, DrawsFiles) {
  if (!CanDraw()) GTEST_SKIP() << "no OpenGL";
  const std::string dir = WriteRun();
  RenderRequest request;
  request.files = {dir + "/frame_0000/femur.ply",
                   dir + "/frame_0000/psoas_major.ply"};
  request.out = dir + "/muscles.png";
  request.size = "100x100";
  std::ostringstream log;
  Render(request, log);
  const std::string all_muscles = Bytes(request.out);
  request.bones = "femur";
  request.out = dir + "/bone.png";
  Render(request, log);
  EXPECT_NE(Bytes(request.out), all_muscles);
  // What the reader of a mesh has to say comes along.
  WriteTextAtomically(dir + "/femur.stl", StlBytes(Box(10, 10, 120)) + "more");
  request.files = {dir + "/femur.stl"};
  Render(request, log);
  EXPECT_THAT(log.str(), HasSubstr("femur.stl: the last 4 bytes were skipped"));
}

TEST(RenderCommand, MistakesNameTheFlagAndLeaveNoPicture) {
  RenderRequest good;
  good.in = WriteRun();
  good.out = good.in + "/a.png";
  const auto error_with = [&](std::string RenderRequest::*field,
                              const std::string& value) {
    RenderRequest request = good;
    request.*field = value;
    return RenderError(request);
  };
  EXPECT_THAT(error_with(&RenderRequest::out, good.in + "/a.jpg"),
              HasSubstr("--out"));
  EXPECT_THAT(error_with(&RenderRequest::in, ""), HasSubstr("--in"));
  EXPECT_THAT(error_with(&RenderRequest::in, good.in + "/no"),
              HasSubstr(good.in + "/no"));
  EXPECT_THAT(error_with(&RenderRequest::frames, "0,3"),
              HasSubstr("--frames: '3'"));
  EXPECT_THAT(error_with(&RenderRequest::frames, ""), HasSubstr("--frames"));
  EXPECT_THAT(error_with(&RenderRequest::size, "300"), HasSubstr("--size"));
  EXPECT_THAT(error_with(&RenderRequest::size, "9x300"), HasSubstr("--size"));
  EXPECT_THAT(error_with(&RenderRequest::captions, "a,b"),
              HasSubstr("--captions"));
  EXPECT_THAT(error_with(&RenderRequest::hide, "tibia"),
              HasSubstr("femur psoas_major"));
  EXPECT_THAT(error_with(&RenderRequest::hide, "femur,psoas_major"),
              HasSubstr("--hide"));
  EXPECT_THAT(error_with(&RenderRequest::fit, "tibia"), HasSubstr("--fit"));
  EXPECT_THAT(error_with(&RenderRequest::bones, "tibia"), HasSubstr("--bones"));
  EXPECT_THAT(error_with(&RenderRequest::fade, "femur"), HasSubstr("--fade"));
  EXPECT_THAT(error_with(&RenderRequest::fade, "femur:2"), HasSubstr("--fade"));
  EXPECT_THAT(error_with(&RenderRequest::view, "front"), HasSubstr("--view"));
}

TEST(RenderCommand, TooManyFramesForTheSizeAreAnError) {
  RenderRequest request;
  request.in = WriteRun();
  request.out = request.in + "/a.png";
  request.frames = "0,1,2,0,1";
  request.size = "64x64";
  EXPECT_THAT(RenderError(request), HasSubstr("--size"));
}

}  // namespace
}  // namespace musclewarp
