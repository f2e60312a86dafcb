// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/meta_image_header.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// Directions and lengths of steps are multiplied again.
constexpr double kRounding = 1e-12;

MadeImage MetaImageOfOnes() {
  return MakeImage({4, 5, 6},
                   TurnedSteps({1, 2, 0.5}, {10, -20, 30}),
                   [](const Eigen::Vector3d&) { return 1; });
}

ImageGrid GridOfMetaImage(const std::string& bytes) {
  const std::string path = TestTempDir() + "/a.mha";
  WriteTextAtomically(path, bytes);
  return ReadMetaImageHeader(path);
}

void ExpectMetaImageRefused(const std::string& text,
                            const std::string& other,
                            const std::vector<std::string>& words) {
  std::string bytes = MetaImageBytes(MetaImageOfOnes());
  bytes.replace(bytes.find(text), text.size(), other);
  ExpectInputError([&] { GridOfMetaImage(bytes); }, words);
}

}  // namespace

TEST(MetaImageHeader, RowsOfTheMatrixAreTheDirectionsOfTheAxes) {
  const MadeImage image = MetaImageOfOnes();
  const ImageGrid grid = GridOfMetaImage(MetaImageBytes(image));
  EXPECT_TRUE(grid.is_oriented);
  EXPECT_TRUE((grid.size == image.size).all());
  EXPECT_TRUE(grid.world_from_index.isApprox(image.lps_from_index, kRounding));
}

TEST(MetaImageHeader, TheDataMayBeInAnotherFile) {
  const std::string dir = TestTempDir();
  std::string bytes = MetaImageBytes(MetaImageOfOnes());
  bytes.replace(bytes.find("LOCAL"), std::string::npos, "a.raw\n");
  WriteTextAtomically(dir + "/a.mhd", bytes);
  const auto read = [&] { ReadMetaImageHeader(dir + "/a.mhd"); };
  ExpectInputError(read, {"ElementDataFile", "a.raw, which does not exist"});
  WriteTextAtomically(dir + "/a.raw", std::string(119, 1));
  ExpectInputError(read, {"a.raw: is truncated: it has 119 bytes"});
  WriteTextAtomically(dir + "/a.raw", std::string(120, 1));
  EXPECT_NO_THROW(read());
}

TEST(MetaImageHeader, RefusesWhatVtkWouldMisread) {
  ExpectMetaImageRefused(
      "NDims = 3", "NDims = 4", {"a.mha: NDims: is '4'; allowed: 3"});
  ExpectMetaImageRefused("ElementType =",
                         "ElementNumberOfChannels = 3\nElementType =",
                         {"ElementNumberOfChannels: is '3'; allowed: 1"});
  ExpectMetaImageRefused(
      "MET_UCHAR", "MET_LONG", {"ElementType: is 'MET_LONG'; allowed"});
  ExpectMetaImageRefused("LOCAL", "LIST", {"ElementDataFile: is 'LIST'"});
  ExpectMetaImageRefused("4 5 6", "4 5", {"DimSize: has 2 numbers"});
  ExpectMetaImageRefused(
      "4 5 6",
      "4 5 7",
      {"is truncated: it has 120 bytes of voxels", "promises 140"});
  ExpectMetaImageRefused("ElementDataFile", "Else", {"ElementDataFile"});
}

}  // namespace musclewarp
