// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/obj_io.h"

#include <gtest/gtest.h>

#include "mesh_files/format_checks.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

constexpr char kObjSquare[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

TriangleSoup ReadNoted(const std::string& bytes,
                       std::vector<std::string>* notes) {
  return ReadObj("a.obj", bytes, notes);
}

TriangleSoup ReadUnnoted(const std::string& bytes) {
  std::vector<std::string> notes;
  const TriangleSoup soup = ReadNoted(bytes, &notes);
  EXPECT_TRUE(notes.empty());
  return soup;
}

void ExpectObjRefusal(const std::string& old_part,
                      const std::string& new_part,
                      const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadUnnoted(With(kObjSquare, old_part, new_part)); },
                   words);
}

TEST(ObjIo, KeepsEveryBit) {
  EXPECT_TRUE(SameBits(ReadUnnoted(ObjBytes(HardSoup())), HardSoup()));
}

TEST(ObjIo, ReadsEveryFormOfCorner) {
  const TriangleSoup soup = ReadUnnoted(
      "# a square\n"
      "mtllib a.mtl\n"
      "o square\n"
      "v 0 0 0 # corner\n"
      "v 1 0 0 0.5 0.5 0.5\n"
      "vt 0 0\nvn 0 0 1\n"
      "f 1/1/1 2//1 3/1\n"
      "v 1 1 0\n"
      "v 0 1 0 1\n"
      "f -4 -2 \\\n -1\n"
      "l 1 2\n"
      "f -4/-1 -3/-1 \\\n"
      "  -2/-1/-1 -1//-1\n");
  EXPECT_EQ(soup.points.rows(), 4);
  EXPECT_EQ(TextOf(soup.triangles), "0 1 2 0 2 3 0 1 2 0 2 3");
}

TEST(ObjIo, VerticesCountFromOne) {
  ExpectObjRefusal("f 1 3 4", "f 1 3 5", {"line 6, face 2", "vertex 5"});
  ExpectObjRefusal("f 1 3 4", "f 1 0 4", {"line 6", "vertex 0"});
}

TEST(ObjIo, NegativeIndicesReachBackToTheFirstVertex) {
  EXPECT_EQ(
      TextOf(ReadUnnoted(With(kObjSquare, "f 1 3 4", "f -4 3 4")).triangles),
      kTwoTriangles);
  ExpectObjRefusal(
      "f 1 3 4", "f 1 -5 4", {"line 6", "vertex -5", "back to -4"});
}

TEST(ObjIo, AVertexWithTwoCoordinatesIsRefused) {
  ExpectObjRefusal("v 1 1 0", "v 1 1", {"line 3", "has 2 coordinates"});
}

// As other readers do: what follows the mesh in such a file does no harm.
TEST(ObjIo, UnknownStatementsAreCountedAndSkipped) {
  std::vector<std::string> notes;
  const TriangleSoup soup = ReadNoted(
      With(kObjSquare, "v 1 1 0\n", "vw 1 0\nv 1 1 0\n$ a\nvw 2 0\n"), &notes);
  EXPECT_TRUE(SameBits(soup, ReadUnnoted(kObjSquare)));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "a.obj: 3 lines that are no OBJ statements were skipped: 'vw' 2 "
            "times, '$'");
}

TEST(ObjIo, ManyKindsOfUnknownStatementsAreCutShort) {
  std::string bytes = kObjSquare;
  for (int i = 0; i < 300; ++i) bytes += "x" + std::to_string(i) + " 1\n";
  std::vector<std::string> notes;
  ReadNoted(bytes, &notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "a.obj: 300 lines that are no OBJ statements were skipped: 'x0', "
            "'x1', 'x2', 'x3', 'x4', ...");
}

TEST(ObjIo, FaceOutlinesOfOldFilesAreFaces) {
  EXPECT_TRUE(SameBits(ReadUnnoted(With(kObjSquare, "f 1 2 3", "fo 1 2 3")),
                       ReadUnnoted(kObjSquare)));
}

TEST(ObjIo, CornersThatAreNoNumbersAreQuoted) {
  ExpectObjRefusal("f 1 3 4", "f 1/x 3 4", {"line 6", "'x'", "texture"});
}

}  // namespace
}  // namespace musclewarp
