// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/point_cache.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>

#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

TEST(PointCaches, GiveEveryFrameBack) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RunOutline run = ReadRunForExport(written.dir, "0");
  const std::string dir = written.dir + "/blender";
  WritePointCaches(dir, AnimationOf(run, {0, 1}));
  const GltfConversion conversion = GltfFromAxes("ASR");
  for (const std::string name : {"muscle", "bone"}) {
    const bool is_bone = name == "bone";
    const TriangleSoup rest = ReadTriangleSoup(dir + "/" + name + ".obj");
    const TriangleSoup& expected = is_bone ? written.bone : written.muscle;
    EXPECT_EQ(rest.points, conversion.Convert(expected.points));
    EXPECT_EQ(rest.triangles, expected.triangles);
    const std::string bytes = ReadFile(dir + "/" + name + ".pc2");
    EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    std::int32_t counts[5];
    std::memcpy(counts, &bytes[12], sizeof(counts));
    EXPECT_EQ(counts[0], 1);  // version
    EXPECT_EQ(counts[1], rest.points.rows());
    EXPECT_EQ(counts[4], 2);  // samples
    Eigen::Matrix<float, -1, 3, Eigen::RowMajor> all(2 * rest.points.rows(), 3);
    ASSERT_EQ(bytes.size(), 32 + all.size() * sizeof(float));
    std::memcpy(all.data(), &bytes[32], all.size() * sizeof(float));
    for (int i = 0; i < 2; ++i) {
      const Points moved =
          all.middleRows(i * rest.points.rows(), rest.points.rows())
              .cast<double>();
      const Points& frame =
          is_bone ? written.bone_frames[i] : written.muscle_frames[i];
      // Floats of some 0.03 m, in mm.
      EXPECT_LT(1e3 * (moved - conversion.Convert(frame)).cwiseAbs().maxCoeff(),
                2e-6);
    }
  }
  // Again, in its place.
  WritePointCaches(dir, AnimationOf(run, {0}));
  EXPECT_TRUE(fs::exists(dir + "/bone.pc2"));
}

TEST(PointCaches, CountFramesAsTheRunDoes) {
  const WrittenRun written = WriteRun(TestTempDir());
  const std::string dir = written.dir + "/blender";
  const auto numbers = [&](const std::vector<int>& frames) {
    Animation animation =
        AnimationOf(ReadRunForExport(written.dir, "0"), {0, 1});
    animation.numbers = frames;
    animation.times.resize(frames.size());
    animation.read = [read = animation.read](int i) { return read(i % 2); };
    WritePointCaches(dir, animation);
    float start_and_step[2];
    const std::string bytes = ReadFile(dir + "/muscle.pc2");
    std::memcpy(start_and_step, &bytes[20], sizeof(start_and_step));
    return std::vector<float>(start_and_step, start_and_step + 2);
  };
  EXPECT_EQ(numbers({7}), std::vector<float>({7, 1}));
  EXPECT_EQ(numbers({7, 12}), std::vector<float>({7, 5}));
  EXPECT_EQ(numbers({7, 12, 17}), std::vector<float>({7, 5}));
  // No step would do.
  EXPECT_EQ(numbers({7, 12, 13}), std::vector<float>({0, 1}));
}

TEST(PointCaches, DoNotReplaceAFolderOfOtherThings) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RunOutline run = ReadRunForExport(written.dir, "0");
  ExpectInputError(
      [&] { WritePointCaches(written.dir, AnimationOf(run, {0})); },
      {written.dir, "would be replaced", "out"});
  EXPECT_TRUE(fs::exists(written.dir + "/report.json"));
  ExpectInputError(
      [&] {
        WritePointCaches(written.dir + "/report.json", AnimationOf(run, {0}));
      },
      {"report.json", "is no folder"});
}

}  // namespace
}  // namespace musclewarp
