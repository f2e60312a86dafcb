// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/box_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Boxes around triangles of very different sizes, in a cube of 40 mm.
std::vector<RoundedBox> RandomBoxes(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-20, 20), unit(-1, 1),
      exponent(-2, 1);
  std::vector<RoundedBox> boxes;
  for (int i = 0; i < count; ++i) {
    const RowVector3d at(place(random), place(random), place(random));
    const double size = std::pow(10, exponent(random));
    Corners corners;
    for (int k = 0; k < 9; ++k) corners.data()[k] = size * unit(random);
    boxes.push_back(RoundedBoxOf(corners.rowwise() + at));
  }
  return boxes;
}

std::vector<int> Found(const BoxGrid& grid,
                       const RoundedBox& box,
                       Eigen::Index count) {
  std::vector<int> found;
  grid.ForEachOverlap(box, count, [&](int i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(BoxGrid, FindsWhatOverlapsEachOnce) {
  const std::vector<RoundedBox> boxes = RandomBoxes(500, 1);
  const BoxGrid grid(boxes);
  size_t sum = 0;
  for (const RoundedBox& box : RandomBoxes(200, 2)) {
    for (const Eigen::Index count :
         {Eigen::Index{0}, Eigen::Index{100}, grid.size()}) {
      std::vector<int> expected;
      for (int i = 0; i < count; ++i) {
        if (boxes[i].Overlaps(box)) expected.push_back(i);
      }
      sum += expected.size();
      EXPECT_EQ(Found(grid, box, count), expected);
    }
  }
  EXPECT_GT(sum, 100u);
}

TEST(BoxGrid, OfNoBoxesFindsNothing) {
  const BoxGrid grid({});
  EXPECT_EQ(grid.size(), 0);
  EXPECT_THAT(Found(grid, RandomBoxes(1, 3)[0], 1), testing::IsEmpty());
}

TEST(RoundedBox, ContainsTheTriangleAndTheMargin) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double size : {1e-30, 1e-3, 1.0, 1e3, 1e9}) {
    for (int i = 0; i < 50; ++i) {
      Corners corners;
      for (int k = 0; k < 9; ++k) corners.data()[k] = size * uniform(random);
      const double margin = std::abs(uniform(random));
      const RoundedBox box = RoundedBoxOf(corners), grown = box.GrownBy(margin);
      for (int k = 0; k < 3; ++k) {
        EXPECT_LE(box.lower[k], corners.col(k).minCoeff());
        EXPECT_GE(box.upper[k], corners.col(k).maxCoeff());
        EXPECT_LE(grown.lower[k], corners.col(k).minCoeff() - margin);
        EXPECT_GE(grown.upper[k], corners.col(k).maxCoeff() + margin);
      }
    }
  }
}

}  // namespace
}  // namespace musclewarp
