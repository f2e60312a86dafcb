// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/frame_files.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/run/bones_file.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(AreaStretch, IsTheRatioOfAreas) {
  const TriangleSoup ball = Icosphere(10, 2);
  const Points twice = 2 * ball.points;
  const Eigen::VectorXd stretch =
      AreaStretch(ball.points, twice, ball.triangles);
  EXPECT_LT((stretch.array() - 4).abs().maxCoeff(), 1e-12);
  EXPECT_LT((AreaStretch(ball.points, ball.points, ball.triangles).array() - 1)
                .abs()
                .maxCoeff(),
            1e-15);
}

TEST(AreaStretch, IsOneWhereThereIsNoArea) {
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5;
  const Triangles triangle = Eigen::RowVector3i(0, 1, 2);
  EXPECT_EQ(AreaStretch(points, 3 * points, triangle)[3], 1);
}

TEST(FrameFolder, HasFourDigits) {
  EXPECT_EQ(FrameFolder(7), "frame_0007");
  EXPECT_EQ(FrameFolder(12345), "frame_12345");
}

TEST(FrameFoldersIn, GoesByNumbers) {
  const std::string dir = TestTempDir();
  for (const char* name :
       {"frame_0010", "frame_0002", "frame_", "frame_2b", "xframe_0001"}) {
    std::filesystem::create_directories(dir + "/" + name);
  }
  std::ofstream(dir + "/frame_0003");  // no folder
  EXPECT_EQ(FrameFoldersIn(dir),
            (std::map<int, std::string>{{2, dir + "/frame_0002"},
                                        {10, dir + "/frame_0010"}}));
}

// A muscle and a bone, which has moved and turned in the frame.
class FrameFilesTest : public ::testing::Test {
 protected:
  FrameFilesTest() {
    const TriangleSoup ball = Icosphere(10.0 / 3, 1);
    const Eigen::Affine3d motion =
        Eigen::Translation3d(80.0 / 3, 1, 2) *
        Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized());
    scene_.muscles.resize(1);
    scene_.muscles[0].model.name = "muscle";
    scene_.muscles[0].model.fine_triangles = ball.triangles;
    scene_.bones.resize(1);
    scene_.bones[0].mesh.name = "bone";
    scene_.bones[0].rest = ball;
    rest_.muscles.resize(1);
    rest_.muscles[0].points = ball.points;
    rest_.bones = {ball.points};
    rest_.bones_from_rest = {Eigen::Matrix4d::Identity()};
    frame_.index = 0;
    frame_.muscles.resize(1);
    frame_.muscles[0].points = ball.points / 7;
    frame_.bones = {Transformed(ball.points, motion.matrix())};
    frame_.bones_from_rest = {motion.matrix()};
  }

  void Write(const FrameFileOptions& options) const {
    WriteFrame(scene_, rest_, options, dir_);
    WriteFrame(scene_, frame_, options, dir_);
  }
  std::vector<std::string> Different(const FrameFileOptions& options) const {
    return FilesThatDiffer(scene_, frame_, options, dir_);
  }
  bool Has(const std::string& file) const {
    return std::filesystem::exists(dir_ + "/" + file);
  }

  const std::string dir_ = TestTempDir();
  const FrameFileOptions every_ = {{"ply", "obj"}, BoneFiles::kEvery};
  const FrameFileOptions once_ = {{"ply", "obj"}, BoneFiles::kOnce};
  PreparedScene scene_;
  Frame rest_, frame_;
};

TEST_F(FrameFilesTest, DifferIfSomebodyChangedThem) {
  Write(every_);
  EXPECT_FALSE(Has("frame_0000/bones.json"));
  EXPECT_THAT(Different(every_), IsEmpty());
  // By one bit of one coordinate.
  double& y = frame_.muscles[0].points(5, 1);
  y = std::nextafter(y, 9);
  EXPECT_THAT(Different({{"ply"}}), ElementsAre("frame_0000/muscle.ply"));
}

TEST_F(FrameFilesTest, HaveBonesOnceIfAskedTo) {
  Write(once_);
  for (const char* format : {".ply", ".obj"}) {
    EXPECT_TRUE(Has("rest/bone" + std::string(format)));
    EXPECT_TRUE(Has("frame_0000/muscle" + std::string(format)));
    EXPECT_FALSE(Has("frame_0000/bone" + std::string(format)));
  }
  EXPECT_FALSE(Has("rest/bones.json"));
  EXPECT_EQ(ReadBonesFile(dir_ + "/frame_0000/bones.json").at("bone"),
            frame_.bones_from_rest[0]);
  EXPECT_THAT(Different(once_), IsEmpty());
}

TEST_F(FrameFilesTest, BonesWrittenOnceAreComparedWhereTheyAreInTheFrame) {
  Write(once_);
  double& y = frame_.bones[0](5, 1);
  y = std::nextafter(y, 99);
  EXPECT_THAT(Different(once_), ElementsAre("rest/bone.ply", "rest/bone.obj"));
  WriteBonesFile(dir_ + "/frame_0000/bones.json", {});
  EXPECT_THAT(Different({{"ply"}, BoneFiles::kOnce}),
              ElementsAre("frame_0000/bones.json"));
}

#ifdef MUSCLEWARP_WITH_VTK
TEST_F(FrameFilesTest, VtpHasBonesInEveryFrame) {
  const FrameFileOptions options = {{"vtp", "ply"}, BoneFiles::kOnce};
  const auto size = frame_.muscles[0].points.rows();
  scene_.muscles[0].model.fine_rest = rest_.muscles[0].points;
  for (Frame* frame : {&rest_, &frame_}) {
    frame->muscles[0].gaps = Eigen::VectorXd::Zero(size);
  }
  Write(options);
  EXPECT_TRUE(Has("frame_0000/bone.vtp"));
  EXPECT_FALSE(Has("frame_0000/bone.ply"));
  EXPECT_THAT(Different(options), IsEmpty());
}
#endif

}  // namespace
}  // namespace musclewarp
