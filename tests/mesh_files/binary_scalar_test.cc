// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/binary_scalar.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace musclewarp {
namespace {

constexpr ByteOrder kOrders[] = {ByteOrder::kLittle, ByteOrder::kBig};

// Every value of a type that is written is read again, at an odd address.
template <typename T>
void ExpectRoundTrip(ScalarType type, const std::vector<T>& values) {
  EXPECT_EQ(SizeOf(type), sizeof(T));
  EXPECT_EQ(IsInteger(type), std::is_integral_v<T>);
  for (const ByteOrder order : kOrders) {
    for (const T value : values) {
      std::string bytes = "x";
      AppendBytes(value, order, &bytes);
      ASSERT_EQ(bytes.size(), 1 + sizeof(T));
      EXPECT_EQ(LoadAs<T>(bytes.data() + 1, order), value);
      EXPECT_EQ(LoadReal(bytes.data() + 1, type, order),
                static_cast<double>(value));
      if (IsInteger(type)) {
        EXPECT_EQ(LoadInteger(bytes.data() + 1, type, order),
                  static_cast<std::int64_t>(value));
      }
    }
  }
}

template <typename T>
std::vector<T> Extremes() {
  return {std::numeric_limits<T>::lowest(),
          T{0},
          T{1},
          std::numeric_limits<T>::max()};
}

TEST(BinaryScalar, EveryTypeComesBack) {
  ExpectRoundTrip(ScalarType::kInt8, Extremes<std::int8_t>());
  ExpectRoundTrip(ScalarType::kUInt8, Extremes<std::uint8_t>());
  ExpectRoundTrip(ScalarType::kInt16, Extremes<std::int16_t>());
  ExpectRoundTrip(ScalarType::kUInt16, Extremes<std::uint16_t>());
  ExpectRoundTrip(ScalarType::kInt32, Extremes<std::int32_t>());
  ExpectRoundTrip(ScalarType::kUInt32, Extremes<std::uint32_t>());
  ExpectRoundTrip(ScalarType::kInt64, Extremes<std::int64_t>());
  ExpectRoundTrip(ScalarType::kUInt64, Extremes<std::uint64_t>());
  ExpectRoundTrip<float>(ScalarType::kFloat32, {0.1f, -1e38f, 1e-45f});
  ExpectRoundTrip<double>(ScalarType::kFloat64, {0.1, -1e308, 5e-324});
}

TEST(BinaryScalar, TheLowestByteIsFirstOrLast) {
  std::string little, big;
  AppendBytes<std::uint32_t>(0x01020304, ByteOrder::kLittle, &little);
  AppendBytes<std::uint32_t>(0x01020304, ByteOrder::kBig, &big);
  EXPECT_EQ(little, "\x04\x03\x02\x01");
  EXPECT_EQ(big, "\x01\x02\x03\x04");
}

TEST(BinaryScalar, UnsignedValuesFrom2To63ComeOutNegative) {
  const std::string bytes(8, '\xff');
  EXPECT_EQ(LoadInteger(bytes.data(), ScalarType::kUInt64, ByteOrder::kBig),
            -1);
}

TEST(BinaryScalarDeathTest, ARealIsNoInteger) {
  const std::string bytes(8, '\0');
  EXPECT_DEATH(LoadInteger(bytes.data(), ScalarType::kFloat64, ByteOrder::kBig),
               "IsInteger");
}

}  // namespace
}  // namespace musclewarp
