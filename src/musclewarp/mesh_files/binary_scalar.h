// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace musclewarp {

// Numbers as mesh files hold them in binary, of either byte order.

enum class ByteOrder { kLittle, kBig };

enum class ScalarType {
  kInt8,
  kUInt8,
  kInt16,
  kUInt16,
  kInt32,
  kUInt32,
  kInt64,
  kUInt64,
  kFloat32,
  kFloat64,
};

std::size_t SizeOf(ScalarType type);

bool IsInteger(ScalarType type);

// The value at `bytes`, of which SizeOf(type) must be readable. Exact for every
// real type and for integers up to 2^53.
double LoadReal(const char* bytes, ScalarType type, ByteOrder order);

// The same for an integer type; unsigned values beyond 2^63 come out negative.
std::int64_t LoadInteger(const char* bytes, ScalarType type, ByteOrder order);

namespace internal {
template <typename T>
void ToOrder(ByteOrder order, char (&bytes)[sizeof(T)]) {
  constexpr ByteOrder kHost = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
                                  ? ByteOrder::kBig
                                  : ByteOrder::kLittle;
  if (order != kHost) std::reverse(bytes, bytes + sizeof(T));
}
}  // namespace internal

template <typename T>
T LoadAs(const char* source, ByteOrder order) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, source, sizeof(T));
  internal::ToOrder<T>(order, bytes);
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <typename T>
void AppendBytes(T value, ByteOrder order, std::string* out) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  internal::ToOrder<T>(order, bytes);
  out->append(bytes, sizeof(T));
}

}  // namespace musclewarp
