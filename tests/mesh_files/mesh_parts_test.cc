// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/obj_io.h"
#include "musclewarp/mesh_files/stl_io.h"
#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A tetrahedron whose first corner is at (x, 0, 0), with faces that count their
// corners from the last vertex back, so that it may stand anywhere in a file.
std::string TetrahedronAt(int x) {
  const std::string at = std::to_string(x), next = std::to_string(x + 1);
  return "v " + at + " 0 0\nv " + next + " 0 0\nv " + at + " 1 0\nv " + at +
         " 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n";
}

struct ObjParts {
  TriangleSoup soup;
  MeshParts parts;
};

ObjParts ReadParts(const std::string& text) {
  ObjParts read;
  std::vector<std::string> notes;
  read.soup = ReadObj("a.obj", text, &notes, &read.parts);
  EXPECT_THAT(notes, IsEmpty());
  return read;
}

TriangleSoup PartOf(const std::string& text, const std::string& name) {
  ObjParts read = ReadParts(text);
  KeepPart("a.obj", name, &read.soup, &read.parts);
  return read.soup;
}

TEST(MeshParts, APartIsThatObjectAlone) {
  const std::string a = "o a\n" + TetrahedronAt(0);
  const std::string b = "o b\n" + TetrahedronAt(5);
  EXPECT_TRUE(SameBits(PartOf(a + b, "a"), ReadParts(a).soup));
  EXPECT_TRUE(SameBits(PartOf(a + b, "b"), ReadParts(b).soup));
}

TEST(MeshParts, TheOrderOfObjectsDoesNotMatter) {
  const std::string a = "o a\n" + TetrahedronAt(0);
  const std::string b = "o b\n" + TetrahedronAt(5);
  for (const char* name : {"a", "b"}) {
    EXPECT_TRUE(SameBits(PartOf(a + b, name), PartOf(b + a, name)));
  }
}

TEST(MeshParts, TheFileIsTheSumOfItsParts) {
  const ObjParts read =
      ReadParts("o a\n" + TetrahedronAt(0) + "o b\n" + TetrahedronAt(5) +
                "o a\n" + TetrahedronAt(9));
  EXPECT_EQ(read.parts.kind, "object");
  EXPECT_THAT(read.parts.names, ElementsAre("a", "b", "a"));
  ASSERT_EQ(read.parts.part_of.size(),
            static_cast<size_t>(read.soup.triangles.rows()));
  Eigen::Index triangles = 0;
  for (int part = 0; part < 3; ++part) {
    triangles += MeshOfPart(read.soup, read.parts, part).triangles.rows();
  }
  EXPECT_EQ(triangles, read.soup.triangles.rows());
}

TEST(MeshParts, ANameStandsForAllObjectsThatHaveIt) {
  ObjParts read = ReadParts("o a\n" + TetrahedronAt(0) + "o b\n" +
                            TetrahedronAt(5) + "o a\n" + TetrahedronAt(9));
  KeepPart("a.obj", "a", &read.soup, &read.parts);
  EXPECT_EQ(read.soup.triangles.rows(), 8);
  EXPECT_THAT(read.parts.names, ElementsAre("a", "a"));
}

TEST(MeshParts, GroupsCountWhereThereIsNoObjectAndGoOn) {
  const std::string groups = "g a\n" + TetrahedronAt(0) + "g b\n" +
                             TetrahedronAt(5) + "g a\n" + TetrahedronAt(9);
  const ObjParts read = ReadParts(groups);
  EXPECT_EQ(read.parts.kind, "group");
  EXPECT_THAT(read.parts.names, ElementsAre("a", "b"));
  EXPECT_EQ(PartOf(groups, "a").triangles.rows(), 8);
  EXPECT_THAT(ReadParts("o all\n" + groups).parts.names, ElementsAre("all"));
}

TEST(MeshParts, PolygonsBelongToTheirObject) {
  EXPECT_EQ(PartOf("o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n"
                   "o b\nf 1 2 3 4\n",
                   "b")
                .triangles.rows(),
            2);
}

TEST(MeshParts, NamesMayHaveBlanksAndMarks) {
  const ObjParts read =
      ReadParts("o  left  psoas \t# the first\n" + TetrahedronAt(0) +
                "o psoas#2\r\n" + TetrahedronAt(5));
  EXPECT_THAT(read.parts.names, ElementsAre("left psoas", "psoas#2"));
}

TEST(MeshParts, FacesWithoutAnObjectAreInTheDefaultOne) {
  EXPECT_THAT(
      ReadParts(TetrahedronAt(0) + "o b\n" + TetrahedronAt(5)).parts.names,
      ElementsAre("default", "b"));
  EXPECT_THAT(ReadParts("g\n" + TetrahedronAt(0)).parts.names,
              ElementsAre("default"));
  EXPECT_THAT(ReadParts(TetrahedronAt(0)).parts.names, IsEmpty());
}

TEST(MeshParts, SolidsOfAnStlAreParts) {
  const std::string facet =
      "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 "
      "endloop endfacet\n";
  MeshParts parts;
  ReadStl("a.stl",
          "solid left psoas\n" + facet + "endsolid left psoas\nsolid\n" +
              facet + facet + "endsolid\n",
          nullptr,
          &parts);
  EXPECT_EQ(parts.kind, "solid");
  EXPECT_THAT(parts.names, ElementsAre("left psoas", "solid_2"));
  EXPECT_THAT(parts.part_of, ElementsAre(0, 1, 1));
  ReadStl("b.stl", StlBytes(UnitTetrahedron()), nullptr, &parts);
  EXPECT_THAT(parts.names, IsEmpty());
}

TEST(MeshParts, RefusesAPartThatIsNotThere) {
  const std::string file = "o nothing\no a\n" + TetrahedronAt(0) + "o b\n" +
                           TetrahedronAt(5) + "o b\n" + TetrahedronAt(7);
  ExpectInputError([&] { PartOf(file, "c"); },
                   {"a.obj", "no object \"c\"", "allowed: a, b"});
  ExpectInputError([&] { PartOf(file, "nothing"); },
                   {"no face in its object \"nothing\"", "allowed: a, b"});
  ExpectInputError([&] { PartOf(file, ""); }, {"allowed: a, b"});
  ExpectInputError([&] { PartOf(TetrahedronAt(0), "c"); },
                   {"no part \"c\"", "leave out \"#c\""});
}

}  // namespace
}  // namespace musclewarp
