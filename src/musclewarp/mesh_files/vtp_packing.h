// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/xml_tags.h"

namespace musclewarp {

// How the binary arrays of a .vtp file are packed, which is the same for all of
// them: attributes of the tag <VTKFile>.
struct VtpPacking {
  // The type of the sizes that stand before the data of an array.
  ScalarType header_type = ScalarType::kUInt32;
  ByteOrder order = ByteOrder::kLittle;
  // The VTK class that compressed the data; "" if they are not compressed.
  std::string compressor;
};

// Returns the packing that the tag <VTKFile> declares. Throws InputError, which
// names `path`, if an attribute has an unknown value.
VtpPacking VtpPackingFromTag(const std::string& path, const XmlTag& root);

// The bytes that an array may unpack to: the corners of 10 million triangles,
// in eight bytes each.
constexpr std::uint64_t kMostArrayBytes = 240000000;

// Unpacks the array at the start of `data`: a header with sizes, then plain
// bytes or compressed blocks. More data may follow the array. The memory taken
// is in proportion to the size of `data`, whatever the header promises, so that
// a damaged file cannot exhaust it. Throws InputError with `where` as its place
// if the data are cut off or damaged, or unpack to more than `most`
// bytes.
std::string UnpackVtpArray(const std::string& where,
                           std::string_view data,
                           const VtpPacking& packing,
                           std::uint64_t most = kMostArrayBytes);

}  // namespace musclewarp
