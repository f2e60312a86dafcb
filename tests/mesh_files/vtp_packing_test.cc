// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_packing.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

VtpPacking Zlib() {
  VtpPacking packing;
  packing.compressor = "vtkZLibDataCompressor";
  return packing;
}

std::string Deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()),
           &size,
           reinterpret_cast<const Bytef*>(bytes.data()),
           bytes.size());
  return packed.substr(0, size);
}

std::string WordBytes(const std::vector<std::uint32_t>& words) {
  std::string bytes;
  for (const std::uint32_t word : words) {
    AppendBytes(word, ByteOrder::kLittle, &bytes);
  }
  return bytes;
}

VtpPacking PackingOf(const std::string& attributes) {
  const std::string text = "<VTKFile " + attributes + ">";
  XmlTag tag;
  EXPECT_TRUE(NextXmlTag(text, 0, &tag));
  return VtpPackingFromTag("a.vtp", tag);
}

TEST(VtpPacking, IsReadFromTheTag) {
  const VtpPacking plain = PackingOf("type='PolyData'");
  EXPECT_EQ(plain.order, ByteOrder::kLittle);
  EXPECT_EQ(plain.header_type, ScalarType::kUInt32);
  EXPECT_EQ(plain.compressor, "");
  const VtpPacking packing = PackingOf(
      "byte_order='BigEndian' header_type='UInt64' "
      "compressor='vtkLZ4DataCompressor'");
  EXPECT_EQ(packing.order, ByteOrder::kBig);
  EXPECT_EQ(packing.header_type, ScalarType::kUInt64);
  EXPECT_EQ(packing.compressor, "vtkLZ4DataCompressor");
}

TEST(VtpPacking, UnknownValuesAreQuoted) {
  ExpectInputError([] { PackingOf("byte_order='Middle'"); },
                   {"a.vtp", "byte_order", "'Middle'"});
  ExpectInputError([] { PackingOf("header_type='UInt8'"); },
                   {"header_type", "'UInt8'"});
  ExpectInputError([] { PackingOf("compressor='zip'"); },
                   {"compressor", "'zip'"});
}

TEST(UnpackVtpArray, PlainBytesEndWhereTheHeaderSays) {
  EXPECT_EQ(UnpackVtpArray("a", WordBytes({3}) + "abcdef", VtpPacking()),
            "abc");
}

TEST(UnpackVtpArray, BlocksAreJoined) {
  // Two whole blocks of 4 bytes and one of 2.
  const std::string a = Deflated("abcd"), b = Deflated("efgh"),
                    c = Deflated("ij");
  const std::string header = WordBytes({3,
                                        4,
                                        2,
                                        static_cast<std::uint32_t>(a.size()),
                                        static_cast<std::uint32_t>(b.size()),
                                        static_cast<std::uint32_t>(c.size())});
  EXPECT_EQ(UnpackVtpArray("a", header + a + b + c + "more", Zlib()),
            "abcdefghij");
}

TEST(UnpackVtpArray, TruncatedDataAreRefused) {
  ExpectInputError(
      [] {
        UnpackVtpArray("a.vtp: piece 0", WordBytes({7}) + "abc", VtpPacking());
      },
      {"a.vtp: piece 0", "promises 7 bytes, 3 bytes follow"});
  ExpectInputError([] { UnpackVtpArray("a", "ab", VtpPacking()); },
                   {"truncated within their header"});
  const std::string block = Deflated("abcd");
  const auto size = static_cast<std::uint32_t>(block.size());
  ExpectInputError(
      [&] {
        UnpackVtpArray("a",
                       WordBytes({1, 4, 0, size}) + block.substr(0, size - 1),
                       Zlib());
      },
      {"bytes in a block"});
}

TEST(UnpackVtpArray, DamagedBlocksAreNamed) {
  std::string block = Deflated("abcd");
  const auto size = static_cast<std::uint32_t>(block.size());
  block[0] = '\0';
  ExpectInputError(
      [&] {
        UnpackVtpArray("a", WordBytes({1, 4, 0, size}) + block, Zlib());
      },
      {"block 0 of 1 cannot be unpacked"});
}

// Would take 0.2 and 17 gigabytes if the header were believed.
TEST(UnpackVtpArray, AbsurdSizesAreRefused) {
  const std::string block = Deflated("abcd");
  const auto size = static_cast<std::uint32_t>(block.size());
  ExpectInputError(
      [&] {
        UnpackVtpArray("a", WordBytes({1, 200000000, 0, size}) + block, Zlib());
      },
      {"200000000 unpacked bytes"});
  ExpectInputError(
      [&] {
        UnpackVtpArray(
            "a", WordBytes({0xffffffff, 4, 0, size}) + block, Zlib());
      },
      {"4294967295 blocks"});
}

TEST(UnpackVtpArray, WhatIsPackedHasALimit) {
  const std::string block = Deflated(std::string(1000, '\0'));
  const auto size = static_cast<std::uint32_t>(block.size());
  const std::string two = WordBytes({2, 1000, 0, size, size}) + block + block;
  EXPECT_EQ(UnpackVtpArray("a", two, Zlib(), 2000).size(), 2000u);
  ExpectInputError([&] { UnpackVtpArray("a", two, Zlib(), 1999); },
                   {"unpacks to more than 1999 bytes"});
  EXPECT_EQ(kMostArrayBytes, 240000000u);
}

}  // namespace
}  // namespace musclewarp
