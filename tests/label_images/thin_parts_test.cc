// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/thin_parts.h"

#include <gtest/gtest.h>

#include <vector>

namespace musclewarp {
namespace {

// A row of voxels along x within a margin, with values of the smoothed region.
struct Row {
  LabelRegion region;
  std::vector<float> values;

  explicit Row(const std::vector<float>& row) {
    const int margin = kRegionMargin;
    region.size = {static_cast<int>(row.size()) + 2 * margin,
                   2 * margin + 1,
                   2 * margin + 1};
    region.is_inside.assign(region.size.prod(), false);
    values.assign(region.size.prod(), 0);
    for (size_t i = 0; i < row.size(); ++i) {
      region.is_inside[At(i)] = true;
      values[At(i)] = row[i];
    }
  }
  std::int64_t At(size_t i) const {
    return (std::int64_t{kRegionMargin} * region.size[1] + kRegionMargin) *
               region.size[0] +
           kRegionMargin + static_cast<std::int64_t>(i);
  }
};

TEST(VoxelsCutOff, ArePartsThatReachFartherThanARim) {
  const Row rim({0.9F, 0.9F, 0.9F, 0.4F, 0.4F});
  EXPECT_TRUE(VoxelsCutOff(rim.region, rim.values.data(), 0.5).empty());
  const Row tendon({0.9F, 0.9F, 0.9F, 0.4F, 0.4F, 0.4F});
  EXPECT_EQ(
      VoxelsCutOff(tendon.region, tendon.values.data(), 0.5),
      (std::vector<std::int64_t>{tendon.At(3), tendon.At(4), tendon.At(5)}));
}

TEST(VoxelsCutOff, BeginWithThePinchAndGoOnBeyondIt) {
  const Row row({0.9F, 0.9F, 0.9F, 0.4F, 0.6F, 0.6F});
  EXPECT_EQ(VoxelsCutOff(row.region, row.values.data(), 0.5),
            (std::vector<std::int64_t>{row.At(3), row.At(4), row.At(5)}));
}

TEST(VoxelsCutOff, ThereAreNoneIfNothingIsInsideOrAllIs) {
  const Row none({0.1F, 0.1F, 0.1F, 0.1F});
  EXPECT_TRUE(VoxelsCutOff(none.region, none.values.data(), 0.5).empty());
  const Row all({0.9F, 0.9F, 0.9F, 0.9F});
  EXPECT_TRUE(VoxelsCutOff(all.region, all.values.data(), 0.5).empty());
}

}  // namespace
}  // namespace musclewarp
