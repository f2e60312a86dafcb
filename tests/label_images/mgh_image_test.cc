// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/mgh_image.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <Eigen/Dense>

#include "musclewarp/base/output_file.h"
#include "musclewarp/label_images/label_image.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// The header has single precision.
constexpr double kSinglePrecision = 1e-5;

// Labels 0 to 6, turned, with even and odd sizes.
MadeImage LabelsInTurnedFrame() {
  int next = 0;
  return MakeImage({12, 5, 4},
                   TurnedSteps({1, 2, 0.5}, {10, -20, 30}),
                   [&next](const Eigen::Vector3d&) { return next++ % 7; });
}

// The file of an image as FreeSurfer writes it, with labels of type T.
template <typename T>
std::string MghBytes(const MadeImage& image, int type, bool has_frame = true) {
  std::string bytes;
  const auto add = [&bytes](auto number) {
    AppendBytes(number, ByteOrder::kBig, &bytes);
  };
  add(std::int32_t{1});
  for (const int size : image.size) add(std::int32_t{size});
  add(std::int32_t{1});  // points of time
  add(std::int32_t{type});
  add(std::int32_t{0});
  add(static_cast<std::int16_t>(has_frame));
  Eigen::Matrix4d ras = image.lps_from_index;
  ras.topRows<2>() *= -1;
  for (int axis = 0; axis < 3; ++axis) {
    add(static_cast<float>(ras.col(axis).head<3>().norm()));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = ras.col(axis).head<3>().normalized();
    for (const double x : direction) add(static_cast<float>(x));
  }
  const Eigen::Vector4d middle(
      image.size[0] / 2.0, image.size[1] / 2.0, image.size[2] / 2.0, 1);
  const Eigen::Vector4d centre = ras * middle;
  for (const double x : centre.head<3>()) add(static_cast<float>(x));
  bytes.resize(284, '\0');
  for (const unsigned char label : image.labels) add(static_cast<T>(label));
  return bytes;
}

void WriteGzip(const std::string& path, const std::string& bytes) {
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
}

void ExpectSameImage(const std::string& path, const MadeImage& expected) {
  const LabelImage image = ReadLabelImage(path);
  EXPECT_TRUE((image.grid.size == expected.size).all());
  EXPECT_EQ(image.labels,
            std::vector<int>(expected.labels.begin(), expected.labels.end()));
  EXPECT_TRUE(image.grid.world_from_index.isApprox(expected.lps_from_index,
                                                   kSinglePrecision))
      << image.grid.world_from_index;
  EXPECT_TRUE(image.grid.is_oriented);
  EXPECT_TRUE(image.notes.empty());
}

TEST(MghImage, IsReadInLpsWhateverItsType) {
  const std::string dir = TestTempDir();
  const MadeImage image = LabelsInTurnedFrame();
  const std::vector<std::string> files = {MghBytes<std::uint8_t>(image, 0),
                                          MghBytes<std::int32_t>(image, 1),
                                          MghBytes<float>(image, 3),
                                          MghBytes<std::int16_t>(image, 4),
                                          MghBytes<std::uint16_t>(image, 10)};
  for (const std::string& bytes : files) {
    WriteTextAtomically(dir + "/a.mgh", bytes);
    ExpectSameImage(dir + "/a.mgh", image);
    // What follows the voxels, such as the way of the scan, is passed over.
    WriteGzip(dir + "/a.MGZ", bytes + "tags");
    ExpectSameImage(dir + "/a.MGZ", image);
  }
}

TEST(MghImage, WithoutAFrameLiesAsInFreeSurfer) {
  const std::string path = TestTempDir() + "/a.mgh";
  WriteTextAtomically(path,
                      MghBytes<std::uint8_t>(LabelsInTurnedFrame(), 0, false));
  const LabelImage image = ReadLabelImage(path);
  EXPECT_FALSE(image.grid.is_oriented);
  ASSERT_EQ(image.notes.size(), 1u);
  EXPECT_NE(image.notes[0].find("coronal slices"), std::string::npos);
  // From right to left, from head to foot, and from back to front.
  const Eigen::Matrix4d& steps = image.grid.world_from_index;
  EXPECT_EQ(steps.col(0).head<3>(), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(steps.col(1).head<3>(), Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(steps.col(2).head<3>(), Eigen::Vector3d(0, -1, 0));
}

TEST(MghImage, DamagedFilesAreRefused) {
  const std::string path = TestTempDir() + "/a.mgh";
  const std::string good = MghBytes<std::uint8_t>(LabelsInTurnedFrame(), 0);
  const auto expect_refused = [&](const std::string& bytes,
                                  const std::vector<std::string>& words) {
    WriteTextAtomically(path, bytes);
    ExpectInputError([&] { ReadMghImage(path); }, words);
  };
  const auto with = [&](int place, char value) {
    std::string bytes = good;
    bytes[place + 3] = value;  // the lowest byte of a number
    return bytes;
  };
  expect_refused(good.substr(0, 200), {"a.mgh", "no image of FreeSurfer"});
  expect_refused(with(0, 7), {"no image of FreeSurfer"});
  expect_refused(good.substr(0, good.size() - 1),
                 {"truncated", "239 bytes", "promises 240"});
  expect_refused(with(16, 2), {"2 points of time"});
  expect_refused(with(20, 9), {"type 9", "mri_convert"});
  expect_refused(with(4, 0), {"0 x 5 x 4 voxels"});
}

}  // namespace
}  // namespace musclewarp
