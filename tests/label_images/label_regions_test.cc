// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_regions.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

// An image of nothing.
LabelImage Blank(const Eigen::Array3i& size) {
  LabelImage image;
  image.grid.size = size;
  image.labels.resize(image.grid.NumVoxels());
  return image;
}

// Gives the voxels of a box, both ends within, a label.
void Fill(const Eigen::Array3i& from,
          const Eigen::Array3i& to,
          int label,
          LabelImage* image) {
  const Eigen::Array3i& size = image->grid.size;
  for (int k = from[2]; k <= to[2]; ++k) {
    for (int j = from[1]; j <= to[1]; ++j) {
      for (int i = from[0]; i <= to[0]; ++i) {
        image->labels[(k * size[1] + j) * size[0] + i] = label;
      }
    }
  }
}

LabelPieces PiecesOf(const LabelImage& image, int label) {
  return PiecesOfLabel(image, label, BoxesOfLabels(image).at(label));
}

LabelRegion RegionOf(const LabelImage& image, int label) {
  return PiecesOf(image, label).regions[0];
}

int NumInside(const LabelRegion& region) {
  int count = 0;
  for (const bool is_inside : region.is_inside) count += is_inside;
  return count;
}

}  // namespace

TEST(LabelRegions, BoxesHoldTheVoxelsOfALabel) {
  LabelImage image = Blank({10, 9, 8});
  Fill({1, 2, 3}, {4, 5, 6}, 3, &image);
  Fill({9, 8, 7}, {9, 8, 7}, 3, &image);
  Fill({0, 0, 0}, {1, 0, 0}, 200, &image);
  const std::map<int, LabelBox> boxes = BoxesOfLabels(image);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_TRUE((boxes.at(3).lowest == Eigen::Array3i(1, 2, 3)).all());
  EXPECT_TRUE((boxes.at(3).highest == Eigen::Array3i(9, 8, 7)).all());
  EXPECT_EQ(boxes.at(3).voxels, 65);
  EXPECT_EQ(boxes.at(200).voxels, 2);
}

TEST(LabelRegions, ThereIsBackgroundAroundALabelAtTheBorder) {
  LabelImage image = Blank({4, 4, 4});
  Fill({0, 0, 0}, {3, 3, 3}, 1, &image);
  const LabelRegion region = RegionOf(image, 1);
  EXPECT_EQ(region.voxels, 64);
  EXPECT_EQ(NumInside(region), 64);
  EXPECT_TRUE((region.first == -kRegionMargin).all());
  EXPECT_TRUE((region.size == 4 + 2 * kRegionMargin).all());
}

// Pieces that share a corner or an edge of voxels have no closed surface in
// common there, however large they are.
TEST(LabelRegions, PiecesHangTogetherByFaces) {
  LabelImage image = Blank({20, 10, 10});
  Fill({0, 0, 0}, {3, 3, 3}, 1, &image);
  Fill({4, 4, 4}, {8, 7, 7}, 1, &image);  // shares a corner with the first
  Fill({9, 8, 4}, {9, 8, 7}, 1, &image);  // shares an edge with the second
  Fill({12, 0, 0}, {13, 0, 0}, 1, &image);
  const LabelPieces pieces = PiecesOf(image, 1);
  ASSERT_EQ(pieces.regions.size(), 2u);
  EXPECT_EQ(pieces.regions[0].voxels, 80);
  EXPECT_TRUE(
      (pieces.regions[0].first + kRegionMargin == Eigen::Array3i(4, 4, 4))
          .all());
  EXPECT_EQ(pieces.regions[1].voxels, 64);
  EXPECT_EQ(NumInside(pieces.regions[0]), 80);
  EXPECT_EQ(NumInside(pieces.regions[1]), 64);
  EXPECT_EQ(pieces.small_pieces, 2);
  EXPECT_EQ(pieces.small_voxels, 6);
}

TEST(LabelRegions, TheLargestPieceIsThereHoweverSmall) {
  LabelImage image = Blank({20, 10, 10});
  Fill({0, 0, 0}, {1, 1, 1}, 1, &image);
  Fill({4, 4, 4}, {4, 4, 4}, 1, &image);
  const LabelPieces pieces = PiecesOf(image, 1);
  ASSERT_EQ(pieces.regions.size(), 1u);
  EXPECT_EQ(pieces.regions[0].voxels, 8);
  EXPECT_EQ(pieces.small_voxels, 1);
}

TEST(LabelRegions, CavitiesAreFilledWhateverIsInThem) {
  LabelImage image = Blank({10, 10, 10});
  Fill({1, 1, 1}, {8, 8, 8}, 1, &image);
  Fill({3, 3, 3}, {4, 4, 4}, 0, &image);
  Fill({6, 6, 6}, {6, 6, 6}, 2, &image);
  Fill({8, 8, 3}, {8, 8, 3}, 0, &image);  // a dent
  const LabelRegion region = RegionOf(image, 1);
  EXPECT_EQ(region.cavity_voxels, 9);
  EXPECT_EQ(region.voxels, 511);
  EXPECT_EQ(NumInside(region), 511);
}

}  // namespace musclewarp
