// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/xml_tags.h"

namespace musclewarp {

// How the binary arrays of a .vtp file are packed: attributes of <VTKFile>.
struct VtpPacking {
  ScalarType header_type = ScalarType::kUInt32;  // Of the sizes before data.
  ByteOrder order = ByteOrder::kLittle;
  std::string compressor;  // VTK class, "" if the data are not compressed.
};

// Throws InputError, naming `path`, if an attribute has an unknown value.
VtpPacking VtpPackingFromTag(const std::string& path, const XmlTag& root);

// The bytes base64 text stands for, up to the first character that is neither
// base64 nor blank. Text of several encodings in a row is allowed.
std::string DecodeBase64(std::string_view text);

// Unpacks the array at the start of `data` (the header, then plain bytes or
// compressed blocks); more data may follow it. Takes memory in proportion to
// `data`, whatever the header promises. Throws InputError with `where` if the
// data are cut or damaged.
std::string UnpackVtpArray(const std::string& where,
                           std::string_view data,
                           const VtpPacking& packing);

}  // namespace musclewarp
