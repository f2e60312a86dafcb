// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/ply_header.h"

#include <gtest/gtest.h>

#include "mesh_files/format_checks.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

constexpr char kHeader[] =
    "ply\n"
    "format binary_big_endian 1.0\n"
    "comment made by hand\n"
    "element vertex 4\n"
    "property float x\n"
    "property uint16 y\n"
    "obj_info none\n"
    "element face 2\n"
    "property list uchar int vertex_indices\n"
    "end_header\n";

PlyHeader Read(const std::string& text) {
  TextCursor cursor("a.ply", text);
  return ReadPlyHeader("a.ply", &cursor);
}

void ExpectPlyHeaderRefusal(const std::string& old_part,
                            const std::string& new_part,
                            const std::vector<std::string>& words) {
  ExpectInputError([&] { Read(With(kHeader, old_part, new_part)); }, words);
}

TEST(PlyHeader, DeclaresElementsAndTheirProperties) {
  const PlyHeader header = Read(kHeader);
  EXPECT_EQ(header.format, PlyFormat::kBinaryBig);
  ASSERT_EQ(header.elements.size(), 2u);
  const PlyElement& vertex = header.elements[0];
  EXPECT_EQ(vertex.name, "vertex");
  EXPECT_EQ(vertex.count, 4);
  ASSERT_EQ(vertex.properties.size(), 2u);
  EXPECT_EQ(vertex.properties[0].name, "x");
  EXPECT_EQ(vertex.properties[0].type, ScalarType::kFloat32);
  EXPECT_FALSE(vertex.properties[0].is_list);
  EXPECT_EQ(vertex.properties[1].type, ScalarType::kUInt16);
  const PlyElement& face = header.elements[1];
  EXPECT_EQ(face.count, 2);
  ASSERT_EQ(face.properties.size(), 1u);
  EXPECT_TRUE(face.properties[0].is_list);
  EXPECT_EQ(face.properties[0].count_type, ScalarType::kUInt8);
  EXPECT_EQ(face.properties[0].type, ScalarType::kInt32);
}

TEST(PlyHeader, EndsBehindItsLastLine) {
  const std::string text = kHeader + std::string("\x01\x02");
  TextCursor cursor("a.ply", text);
  ReadPlyHeader("a.ply", &cursor);
  EXPECT_EQ(cursor.TakeBytes(cursor.bytes_left()), "\x01\x02");
}

TEST(PlyHeader, OtherFilesAreNamed) {
  ExpectInputError([] { Read("solid a\n"); },
                   {"a.ply", "not a PLY", "'solid'"});
  ExpectInputError([] { Read(""); }, {"a.ply", "not a PLY"});
}

TEST(PlyHeader, ATruncatedOneIsRefused) {
  ExpectPlyHeaderRefusal("end_header\n", "", {"is truncated", "'end_header'"});
}

TEST(PlyHeader, UnknownWordsAreQuotedWithTheirLine) {
  ExpectPlyHeaderRefusal("binary_big_endian", "binary", {"line 2", "'binary'"});
  ExpectPlyHeaderRefusal(
      "property float", "property real", {"line 5", "'real'"});
  ExpectPlyHeaderRefusal("element face 2", "face 2", {"line 8", "'face'"});
  ExpectPlyHeaderRefusal("vertex 4", "vertex four", {"line 4", "'four'"});
}

TEST(PlyHeader, ElementsAndPropertiesMustMakeSense) {
  ExpectPlyHeaderRefusal(
      "element face", "element vertex", {"line 8", "stands twice"});
  ExpectPlyHeaderRefusal("face 2", "face -2", {"line 8", "is -2"});
  ExpectPlyHeaderRefusal(
      "element vertex 4\n", "", {"before the first element"});
  ExpectPlyHeaderRefusal(
      "list uchar", "list float", {"line 9", "'float'", "whole"});
  ExpectPlyHeaderRefusal(
      "list uchar int", "list uchar", {"line 9", "two types"});
}

// VTK and MeshLab skip what they do not know.
TEST(PlyHeader, LinesOfOtherKindsAreSkipped) {
  const PlyHeader header = Read(
      "ply  \r\n"
      "\r\n"
      "comment  \r\n"
      "format binary_big_endian 1.0 \t\r\n"
      "obj_info\r\n"
      "version 1.0\r\n"
      "element vertex 4 of them\r\n"
      "property float x in mm\r\n"
      "TextureFile a.png\r\n"
      "element face 2\r\n"
      "comment between\r\n"
      "property list uint8 int32 vertex_index extra\r\n"
      "end_header \r\n");
  ASSERT_EQ(header.elements.size(), 2u);
  EXPECT_EQ(header.elements[0].properties.at(0).name, "x");
  EXPECT_EQ(header.elements[1].properties.at(0).name, "vertex_index");
  EXPECT_EQ(header.elements[1].properties.at(0).type, ScalarType::kInt32);
}

TEST(PlyHeader, NeedsAFormat) {
  ExpectPlyHeaderRefusal(
      "format binary_big_endian 1.0\n", "", {"line 9", "'end_header'"});
}

}  // namespace
}  // namespace musclewarp
