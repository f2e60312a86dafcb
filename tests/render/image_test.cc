// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/image.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "musclewarp/base/input_error.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(Image, DownsamplingTakesTheRoundedMean) {
  const Image image{4,
                    2,
                    {{10, 0, 0},
                     {20, 0, 0},
                     {1, 2, 3},
                     {1, 2, 3},
                     {30, 0, 255},
                     {41, 1, 255},
                     {1, 2, 3},
                     {1, 2, 3}}};
  const Image small = Downsample(image, 2);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.At(0, 0), (Color{25, 0, 128}));
  EXPECT_EQ(small.At(1, 0), (Color{1, 2, 3}));
}

TEST(Image, PngFilesHaveTheSignatureAndTheSize) {
  const std::string path = TestTempDir() + "/a.png";
  WritePng(path, {3, 2, std::vector<Color>(6, {9, 8, 7})});
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  ASSERT_GT(bytes.size(), 24u);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\3\0\0\0\2", 8));
}

TEST(Image, AMissingFolderIsAnInputError) {
  EXPECT_THROW(WritePng(TestTempDir() + "/nowhere/a.png", {1, 1, {{}}}),
               InputError);
}

}  // namespace
}  // namespace musclewarp
