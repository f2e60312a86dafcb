// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/depth_cues.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

constexpr Color kGray{200, 200, 200};

Image GrayImage(int width, int height) {
  return {width, height, std::vector<Color>(width * height, kGray)};
}

// A plane that recedes to the right, with one pixel column after another
// `slope` deeper.
DepthMap Slope(int width, int height, float slope) {
  DepthMap map{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) map.depth.push_back(0.1f + slope * x);
  }
  return map;
}

TEST(DepthCues, OutlinesAreDrawnOnTheNearerSideOfAStepOnly) {
  DepthMap map = Slope(20, 10, 0.001f);
  for (int y = 0; y < 10; ++y) {
    for (int x = 10; x < 20; ++x) map.depth[y * 20 + x] += 0.1f;
  }
  Image image = GrayImage(20, 10);
  DrawOutlines(map, 2, &image);
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(image.At(x, 5) != kGray, x == 8 || x == 9) << x;
  }
}

TEST(DepthCues, OutlinesSurroundWhatStandsBeforeTheBackground) {
  DepthMap map = Slope(12, 12, 0);
  for (int i = 0; i < 12; ++i) map.depth[i] = DepthMap::kBackground;
  Image image = GrayImage(12, 12);
  DrawOutlines(map, 1, &image);
  EXPECT_EQ(image.At(6, 0), kGray);
  EXPECT_LT(image.At(6, 1).r, kGray.r);
  EXPECT_EQ(image.At(6, 2), kGray);
}

TEST(DepthCues, AFlatFaceHasNoFolds) {
  const DepthMap map = Slope(60, 60, 0);
  Image image = GrayImage(60, 60);
  DarkenFolds(map, &image);
  EXPECT_EQ(image.pixels, GrayImage(60, 60).pixels);
}

TEST(DepthCues, APitIsDarkAndItsSurroundingsAreNot) {
  DepthMap map = Slope(120, 120, 0);
  map.depth[60 * 120 + 60] += 0.05f;
  Image image = GrayImage(120, 120);
  DarkenFolds(map, &image);
  EXPECT_LT(image.At(60, 60).r, kGray.r / 2);
  EXPECT_EQ(image.At(58, 60), kGray);
  EXPECT_EQ(image.At(10, 10), kGray);
}

TEST(DepthCues, TheBackgroundCountsForNothing) {
  DepthMap map = Slope(60, 60, 0);
  for (int i = 0; i < 30 * 60; ++i) map.depth[i] = DepthMap::kBackground;
  Image image = GrayImage(60, 60);
  DarkenFolds(map, &image);
  EXPECT_EQ(image.pixels, GrayImage(60, 60).pixels);
}

}  // namespace
}  // namespace musclewarp
