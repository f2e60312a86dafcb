// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_packing.h"

#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <cstdint>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/mesh_files/vtk_errors.h"

namespace musclewarp {
namespace {

vtkSmartPointer<vtkDataCompressor> NewCompressor(const std::string& name) {
  if (name == "vtkZLibDataCompressor") {
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
  }
  if (name == "vtkLZ4DataCompressor") {
    return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  }
  if (name == "vtkLZMADataCompressor") {
    return vtkSmartPointer<vtkLZMADataCompressor>::New();
  }
  return nullptr;
}

[[noreturn]] void ThrowTruncated(const std::string& where,
                                 std::uint64_t promised,
                                 const char* what,
                                 std::size_t left) {
  throw InputError(where,
                   "the header promises " + std::to_string(promised) + " " +
                       what + ", " + std::to_string(left) +
                       " bytes follow: the data are truncated or damaged",
                   kCopyAgain);
}

// Takes header words off the front of the data.
class HeaderReader {
 public:
  HeaderReader(const std::string& where,
               std::string_view data,
               const VtpPacking& packing)
      : where_(where), data_(data), packing_(packing) {}

  std::uint64_t Next() {
    const std::size_t size = SizeOf(packing_.header_type);
    if (data_.size() < size) {
      throw InputError(
          where_, "the data are truncated within their header", kCopyAgain);
    }
    const auto word = static_cast<std::uint64_t>(
        LoadInteger(data_.data(), packing_.header_type, packing_.order));
    data_.remove_prefix(size);
    return word;
  }
  std::string_view rest() const { return data_; }

 private:
  const std::string& where_;
  std::string_view data_;
  const VtpPacking& packing_;
};

// Compressed data start with the number of blocks, the size of a block, the
// size of the last block (0 if that is whole, too), and the compressed size of
// each block.
std::string UnpackBlocks(const std::string& where,
                         std::string_view data,
                         const VtpPacking& packing,
                         std::uint64_t most) {
  HeaderReader header(where, data, packing);
  const std::uint64_t num_blocks = header.Next();
  const std::uint64_t block_size = header.Next();
  const std::uint64_t last_size = header.Next();
  if (num_blocks > header.rest().size()) {
    ThrowTruncated(where, num_blocks, "blocks", header.rest().size());
  }
  if (num_blocks > 0 && block_size > most / num_blocks) {
    throw InputError(where,
                     "unpacks to more than " + std::to_string(most) + " bytes",
                     "simplify the mesh, if the file is sound");
  }
  std::vector<std::uint64_t> packed_sizes;
  for (std::uint64_t i = 0; i < num_blocks; ++i) {
    packed_sizes.push_back(header.Next());
  }
  std::string_view rest = header.rest();
  const auto compressor = NewCompressor(packing.compressor);
  const VtkErrorScope errors;
  std::string bytes;
  for (std::uint64_t i = 0; i < num_blocks; ++i) {
    const bool is_cut = i + 1 == num_blocks && last_size > 0;
    const std::uint64_t size = is_cut ? last_size : block_size;
    const std::uint64_t packed = packed_sizes[i];
    if (packed > rest.size()) {
      ThrowTruncated(where, packed, "bytes in a block", rest.size());
    }
    // Deflate makes at most 1032 bytes of one. The constant leaves room for the
    // other compressors, which may make more.
    if (size > 1032 * packed + (1 << 24)) {
      ThrowTruncated(where, size, "unpacked bytes", packed);
    }
    const std::size_t begin = bytes.size();
    bytes.resize(begin + size);
    const std::size_t unpacked = compressor->Uncompress(
        reinterpret_cast<const unsigned char*>(rest.data()),
        packed,
        reinterpret_cast<unsigned char*>(bytes.data() + begin),
        size);
    if (unpacked != size) {
      throw InputError(where,
                       "block " + std::to_string(i) + " of " +
                           std::to_string(num_blocks) +
                           " cannot be unpacked, the data are damaged",
                       kCopyAgain);
    }
    rest.remove_prefix(packed);
  }
  return bytes;
}

}  // namespace

VtpPacking VtpPackingFromTag(const std::string& path, const XmlTag& root) {
  VtpPacking packing;
  const auto refuse = [&](const char* attribute, const char* allowed) {
    throw InputError(path,
                     std::string(attribute) + " is " +
                         Quoted(root.Attribute(attribute)) + ", allowed is " +
                         allowed,
                     kCopyAgain);
  };
  const std::string_view order = root.Attribute("byte_order");
  if (order == "BigEndian") {
    packing.order = ByteOrder::kBig;
  } else if (!order.empty() && order != "LittleEndian") {
    refuse("byte_order", "LittleEndian or BigEndian");
  }
  const std::string_view header = root.Attribute("header_type");
  if (header == "UInt64") {
    packing.header_type = ScalarType::kUInt64;
  } else if (!header.empty() && header != "UInt32") {
    refuse("header_type", "UInt32 or UInt64");
  }
  packing.compressor = root.Attribute("compressor");
  if (!packing.compressor.empty() && !NewCompressor(packing.compressor)) {
    refuse("compressor",
           "vtkZLibDataCompressor, vtkLZ4DataCompressor or "
           "vtkLZMADataCompressor");
  }
  return packing;
}

std::string UnpackVtpArray(const std::string& where,
                           std::string_view data,
                           const VtpPacking& packing,
                           std::uint64_t most) {
  if (!packing.compressor.empty()) {
    return UnpackBlocks(where, data, packing, most);
  }
  HeaderReader header(where, data, packing);
  const std::uint64_t size = header.Next();
  if (size > header.rest().size()) {
    ThrowTruncated(where, size, "bytes", header.rest().size());
  }
  return std::string(header.rest().substr(0, size));
}

}  // namespace musclewarp
