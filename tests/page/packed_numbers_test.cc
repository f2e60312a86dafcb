// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/packed_numbers.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "page/packed_text.h"

namespace musclewarp {
namespace {

TEST(PackedNumbers, ComeBackAsTheyWere) {
  std::mt19937 random(1);
  PackedNumbers packed;
  std::vector<std::vector<int>> lists = {
      {}, {0}, {-1}, {1 << 30, -(1 << 30), 0, 1 << 30}, {63, 64, -64, -65}};
  for (const int range : {3, 300, 1 << 29}) {
    std::uniform_int_distribution<int> number(-range, range);
    std::vector<int> list(500);
    for (int& value : list) value = number(random);
    lists.push_back(list);
  }
  std::vector<nlohmann::ordered_json> places;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    places.push_back(packed.Add(lists[i], static_cast<int>(1 + 2 * i)));
  }
  const std::string text = packed.Base64();
  for (std::size_t i = 0; i < lists.size(); ++i) {
    EXPECT_EQ(UnpackedNumbers(text, places[i]), lists[i]) << i;
  }
}

TEST(PackedNumbers, WhatDoesNotMoveCostsAByteANumber) {
  PackedNumbers packed;
  const std::vector<int> pose = {100000, -200000, 300000};
  std::vector<int> poses;
  for (int i = 0; i < 10; ++i)
    poses.insert(poses.end(), pose.begin(), pose.end());
  packed.Add(poses, 3);
  const auto next = packed.Add(std::vector<int>{7}, 1);
  EXPECT_EQ(next["at"], 3 * 3 + 9 * 3);
}

TEST(AppendRounded, IsWithinHalfAStep) {
  Points points(2, 3);
  points << 0.1, -0.26, 1000.0001, -5e5, 0, 0.125;
  std::vector<int> numbers;
  AppendRounded(points, 0.01, &numbers);
  ASSERT_EQ(numbers.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_LE(std::abs(0.01 * numbers[i] - points.data()[i]), 0.005 + 1e-9);
  }
}

}  // namespace
}  // namespace musclewarp
