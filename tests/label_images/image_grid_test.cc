// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/image_grid.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

ImageGrid SmallGrid() {
  ImageGrid grid;
  grid.size = {4, 5, 6};
  grid.world_from_index = TurnedSteps({1, 2, 0.5}, {10, -20, 30});
  return grid;
}

void ExpectGridRefused(const ImageGrid& grid,
                       const std::vector<std::string>& words) {
  ExpectInputError([&] { CheckGrid("a.nii", grid); }, words);
}

}  // namespace

TEST(ImageGrid, AVoxelHasTheVolumeOfItsSteps) {
  EXPECT_NEAR(SmallGrid().VoxelVolume(), 1, 1e-12);
  EXPECT_EQ(SmallGrid().NumVoxels(), 120);
  EXPECT_NO_THROW(CheckGrid("a.nii", SmallGrid()));
}

TEST(ImageGrid, TurnsFromRas) {
  ImageGrid grid = SmallGrid();
  TurnFromRas(&grid);
  EXPECT_EQ(grid.world_from_index(0, 3), -10);
  EXPECT_EQ(grid.world_from_index(1, 3), 20);
  EXPECT_EQ(grid.world_from_index(2, 3), 30);
  EXPECT_TRUE(grid.is_oriented);
}

TEST(ImageGrid, RefusesWhatIsNoPlaceForVoxels) {
  ImageGrid grid = SmallGrid();
  grid.size[1] = 0;
  ExpectGridRefused(grid, {"a.nii: has 4 x 0 x 6 voxels", "at least 1"});
  grid.size = {30000, 30000, 30000};
  ExpectGridRefused(grid, {"has 30000 x 30000 x 30000", "at most 5e8", "crop"});
  grid = SmallGrid();
  grid.world_from_index.col(2) *= 0.001;
  ExpectGridRefused(grid, {"0.0005 mm apart along axis 2", "0.001 to 100 mm"});
  grid = SmallGrid();
  grid.world_from_index.col(2) = grid.world_from_index.col(1);
  ExpectGridRefused(grid, {"directions of its axes lie in a plane"});
  grid = SmallGrid();
  grid.world_from_index(0, 3) = 1e8;
  ExpectGridRefused(grid, {"farther than 1e7 mm"});
}

TEST(ImageGrid, HeaderNumbersStandBetweenBlanksCommasAndBrackets) {
  const std::vector<double> expected = {1, -2.5, 3e2};
  EXPECT_EQ(HeaderNumbers("a", "1 -2.5\t3e2", 3), expected);
  EXPECT_EQ(HeaderNumbers("a", "(1,-2.5,300)", 3), expected);
  ExpectInputError([] { HeaderNumbers("a", "1 2", 3); },
                   {"a: has 2 numbers; 3 are expected"});
  ExpectInputError([] { HeaderNumbers("a", "1 none 3", 3); },
                   {"a: has 'none', which is no number"});
  ExpectInputError([] { HeaderNumbers("a", "1 nan 3", 3); }, {"'nan'"});
}

TEST(ImageGrid, HeaderSizesAreWholeNumbersAboveZero) {
  EXPECT_TRUE((HeaderSizes("a", "4 5 6") == Eigen::Array3i(4, 5, 6)).all());
  for (const char* sizes : {"4 0 6", "4 5.5 6", "4 -5 6", "4 5 1e12"}) {
    ExpectInputError([&] { HeaderSizes("a: sizes", sizes); },
                     {"a: sizes: is", "whole numbers above 0"});
  }
}

TEST(ImageGrid, DataHaveToBeThere) {
  const std::string path = TestTempDir() + "/data";
  WriteTextAtomically(path, "0123456789");
  EXPECT_NO_THROW(CheckDataSize(path, 4, 6));
  ExpectInputError([&] { CheckDataSize(path, 4, 7); },
                   {"is truncated: it has 6 bytes", "promises 7"});
  ExpectInputError([&] { CheckDataSize(path, 11, 1); }, {"has 0 bytes"});
}

}  // namespace musclewarp
