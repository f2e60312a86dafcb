// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/legacy_vtk_io.h"

#include <gtest/gtest.h>

#include <string>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr char kVtkSquare[] =
    "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\n"
    "POINTS 4 double\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "POLYGONS 2 8\n3 0 1 2\n3 0 2 3\n";

void ExpectVtkRefusal(const std::string& bytes,
                      const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadLegacyVtk("a.vtk", bytes); }, words);
}

// A file of version 5.1: the square as one polygon, with these offsets.
std::string Version5(const std::vector<int>& offsets) {
  std::string bytes =
      "# vtk DataFile Version 5.1\nvtk output\nBINARY\nDATASET POLYDATA\n"
      "POINTS 4 float\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
    AppendBytes<float>(x, ByteOrder::kBig, &bytes);
  }
  bytes += "\nPOLYGONS " + std::to_string(offsets.size()) +
           " 4\nOFFSETS vtktypeint64\n";
  for (const int x : offsets) {
    AppendBytes<std::int64_t>(x, ByteOrder::kBig, &bytes);
  }
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const int x : {0, 1, 2, 3}) {
    AppendBytes<std::int64_t>(x, ByteOrder::kBig, &bytes);
  }
  return bytes + "\n";
}

TEST(LegacyVtkIo, KeepsEveryBit) {
  EXPECT_TRUE(
      SameBits(ReadLegacyVtk("a.vtk", LegacyVtkBytes(HardSoup())), HardSoup()));
}

TEST(LegacyVtkIo, AsciiReadsPolygonsAndStrips) {
  const TriangleSoup soup =
      ReadLegacyVtk("strips.vtk",
                    "# vtk DataFile Version 2.0\n"
                    "title\nASCII\nDATASET POLYDATA\n"
                    "FIELD FieldData 1\nTimeValue 1 1 double\n0.5\n"
                    "POINTS 4 double\n0 0 0 1 0 0\n0.10000000000000001\n"
                    "1 0 1 1 0\n"
                    "METADATA\nINFORMATION 0\n\n"
                    "LINES 1 3\n2 0 1\n"
                    "POLYGONS 1 5\n4 0 1 3 2\n"
                    "TRIANGLE_STRIPS 1 6\n5 0 1 2 3 3\n"
                    "POINT_DATA 4\nSCALARS s float\nLOOKUP_TABLE default\n"
                    "1 2 3 4\n");
  EXPECT_EQ(soup.points.row(2), Eigen::RowVector3d(0.1, 1, 0));
  EXPECT_EQ(TextOf(soup.triangles), "0 1 3 0 3 2 0 1 2 2 1 3");
}

TEST(LegacyVtkIo, Version5Reads) {
  EXPECT_EQ(TextOf(ReadLegacyVtk("a.vtk", Version5({0, 4})).triangles),
            kTwoTriangles);
}

TEST(LegacyVtkIo, OffsetsOfVersion5MustRiseToTheNumberOfCorners) {
  ExpectVtkRefusal(Version5({0, 3}), {"'polygons'", "run from 0 to 4"});
  ExpectVtkRefusal(Version5({1, 4}), {"'polygons'", "run from 0 to 4"});
  ExpectVtkRefusal(Version5({0, 5, 4}), {"offset 1 is 5 after 0"});
}

TEST(LegacyVtkIo, OtherDatasetsAreNamed) {
  ExpectVtkRefusal(With(kVtkSquare, "POLYDATA", "STRUCTURED_GRID"),
                   {"STRUCTURED_GRID", "POLYDATA"});
}

TEST(LegacyVtkIo, OtherFilesAreNamed) {
  ExpectVtkRefusal("solid a\n",
                   {"a.vtk", "not a legacy VTK file", "'solid a'"});
  ExpectVtkRefusal(With(kVtkSquare, "ASCII", "UTF8"), {"line 3", "'utf8'"});
  ExpectVtkRefusal(With(kVtkSquare, "POLYGONS", "POLYHEDRA"),
                   {"line 10", "'POLYHEDRA'"});
}

TEST(LegacyVtkIo, TheListOfCellsMustBeAsLongAsItSays) {
  ExpectVtkRefusal(With(kVtkSquare, "2 8", "1 8"), {"take 4 of the 8"});
  ExpectVtkRefusal(With(kVtkSquare, "3 0 2 3", "9 0 2 3"),
                   {"cell 1 of 2 has 9 corners"});
  ExpectVtkRefusal(With(kVtkSquare, "2 8", "3 8"), {"cell 2 of 3 is missing"});
}

// Would take tens of gigabytes if the header were believed.
TEST(LegacyVtkIo, AbsurdCountsAreRefused) {
  ExpectVtkRefusal(
      With(LegacyVtkBytes(UnitTetrahedron()), "POINTS 4", "POINTS 4000000000"),
      {"promises 12000000000 numbers"});
  ExpectVtkRefusal(With(kVtkSquare, "2 8", "2 4000000000"), {"is truncated"});
  ExpectVtkRefusal(With(kVtkSquare, "POINTS 4", "POINTS -4"),
                   {"-4", "0 to 2^40"});
}

}  // namespace
}  // namespace musclewarp
