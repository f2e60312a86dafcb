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

// Numbers as binary mesh files hold them: of ten types and in either byte
// order, at addresses that need not be aligned.

// The order of the bytes of a number, lowest byte first or highest byte first.
enum class ByteOrder { kLittle, kBig };

// The number types that PLY and VTK files know.
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

// Returns the number of bytes that a number of this type takes.
std::size_t SizeOf(ScalarType type);

// True for the integer types, signed or not.
bool IsInteger(ScalarType type);

// Returns the number that starts at `bytes`, of which SizeOf(type) must be
// readable. The result is exact for both real types and for integers of up to
// 2^53 in magnitude.
double LoadReal(const char* bytes, ScalarType type, ByteOrder order);

// Returns the integer that starts at `bytes`, of which SizeOf(type) must be
// readable. Unsigned values of 2^63 or more come out negative. Precondition
// (CHECKed): the type is an integer type.
std::int64_t LoadInteger(const char* bytes, ScalarType type, ByteOrder order);

namespace internal {
// Converts the bytes of a T between `order` and the order of this machine.
template <typename T>
void ToOrder(ByteOrder order, char (&bytes)[sizeof(T)]) {
  constexpr ByteOrder kHost = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
                                  ? ByteOrder::kBig
                                  : ByteOrder::kLittle;
  if (order != kHost) std::reverse(bytes, bytes + sizeof(T));
}
}  // namespace internal

// Returns the T that starts at `source`, where the type is known when the code
// is compiled.
template <typename T>
T LoadAs(const char* source, ByteOrder order) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, source, sizeof(T));
  internal::ToOrder<T>(order, bytes);
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

// Appends the bytes of a number to `out`; the inverse of LoadAs.
template <typename T>
void AppendBytes(T value, ByteOrder order, std::string* out) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  internal::ToOrder<T>(order, bytes);
  out->append(bytes, sizeof(T));
}

}  // namespace musclewarp
