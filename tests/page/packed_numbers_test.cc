// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/packed_numbers.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <limits>
#include <random>
#include <string>

namespace musclewarp {
namespace {

std::string DecodedBase64(const std::string& text) {
  const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  int bits = 0;
  unsigned value = 0;
  for (const char c : text) {
    if (c == '=') break;
    value = value << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes += static_cast<char>(value >> bits & 255);
    }
  }
  return bytes;
}

std::string Inflated(const std::string& bytes) {
  std::string text(100000, '\0');
  uLongf size = text.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()),
                       &size,
                       reinterpret_cast<const Bytef*>(bytes.data()),
                       bytes.size()),
            Z_OK);
  text.resize(size);
  return text;
}

// Read as the header says, on its own.
std::vector<int> Unpacked(const std::string& bytes,
                          const nlohmann::ordered_json& where) {
  std::size_t at = where["at"];
  const std::size_t count = where["count"], stride = where["stride"];
  std::vector<int> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t code = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes[at++]);
      code |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
    }
    const auto half = static_cast<std::int64_t>(code >> 1);
    const std::int64_t difference = code & 1 ? -half - 1 : half;
    numbers.push_back(
        static_cast<int>(difference + (i < stride ? 0 : numbers[i - stride])));
  }
  return numbers;
}

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
  const std::string bytes = Inflated(DecodedBase64(packed.Base64()));
  for (std::size_t i = 0; i < lists.size(); ++i) {
    EXPECT_EQ(Unpacked(bytes, places[i]), lists[i]) << i;
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
