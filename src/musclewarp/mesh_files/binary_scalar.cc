// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/binary_scalar.h"

#include <glog/logging.h>

namespace musclewarp {
namespace {

// Calls `visit` with a zero of the C++ type that `type` stands for.
template <typename Visitor>
auto Visit(ScalarType type, const Visitor& visit) {
  switch (type) {
    case ScalarType::kInt8:
      return visit(std::int8_t{});
    case ScalarType::kUInt8:
      return visit(std::uint8_t{});
    case ScalarType::kInt16:
      return visit(std::int16_t{});
    case ScalarType::kUInt16:
      return visit(std::uint16_t{});
    case ScalarType::kInt32:
      return visit(std::int32_t{});
    case ScalarType::kUInt32:
      return visit(std::uint32_t{});
    case ScalarType::kInt64:
      return visit(std::int64_t{});
    case ScalarType::kUInt64:
      return visit(std::uint64_t{});
    case ScalarType::kFloat32:
      return visit(float{});
    case ScalarType::kFloat64:
      break;
  }
  return visit(double{});
}

}  // namespace

std::size_t SizeOf(ScalarType type) {
  return Visit(type, [](auto zero) { return sizeof(zero); });
}

bool IsInteger(ScalarType type) {
  return type != ScalarType::kFloat32 && type != ScalarType::kFloat64;
}

double LoadReal(const char* bytes, ScalarType type, ByteOrder order) {
  return Visit(type, [&](auto zero) {
    return static_cast<double>(LoadAs<decltype(zero)>(bytes, order));
  });
}

std::int64_t LoadInteger(const char* bytes, ScalarType type, ByteOrder order) {
  CHECK(IsInteger(type));
  return Visit(type, [&](auto zero) -> std::int64_t {
    // The branch for reals is never taken; converting a damaged one would be
    // undefined.
    if constexpr (std::is_integral_v<decltype(zero)>) {
      return static_cast<std::int64_t>(LoadAs<decltype(zero)>(bytes, order));
    } else {
      return 0;
    }
  });
}

}  // namespace musclewarp
