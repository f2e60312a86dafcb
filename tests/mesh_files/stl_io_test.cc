// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/stl_io.h"

#include <gtest/gtest.h>

#include <string>

#include "mesh_files/format_checks.h"
#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr char kFacet[] =
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n"
    "      vertex 1 0 0\n      vertex 1 1 0\n    endloop\n  endfacet\n";

TEST(StlIo, KeepsFacetsAndMergesEqualCorners) {
  TriangleSoup sphere = Icosphere(10, 2);
  sphere.points = sphere.points.cast<float>().cast<double>();
  const TriangleSoup read = ReadStl("a.stl", StlBytes(sphere));
  EXPECT_EQ(read.points.rows(), sphere.points.rows());
  ASSERT_EQ(read.triangles.rows(), sphere.triangles.rows());
  // The points come in the order the facets name them, so compare positions.
  for (Eigen::Index f = 0; f < sphere.triangles.rows(); ++f) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(read.points.row(read.triangles(f, i)),
                sphere.points.row(sphere.triangles(f, i)));
    }
  }
}

TEST(StlIo, RoundsToFloat) {
  TriangleSoup soup = UnitTetrahedron();
  soup.points(1, 0) = 0.1;
  const TriangleSoup read = ReadStl("a.stl", StlBytes(soup));
  EXPECT_EQ(read.points.col(0).maxCoeff(), static_cast<double>(0.1f));
}

TEST(StlIo, NormalsPointOutOfTheTriangles) {
  // 84 bytes of header, then the normal of the first facet.
  const std::string bytes = StlBytes(UnitTetrahedron());
  float normal[3];
  bytes.copy(reinterpret_cast<char*>(normal), sizeof(normal), 84);
  EXPECT_EQ(Eigen::RowVector3f(normal[0], normal[1], normal[2]),
            Eigen::RowVector3f(0, 0, -1));
}

TEST(StlIo, AsciiReadsLikeBinary) {
  const std::string other =
      "  FACET NORMAL nan nan nan\r\n    OUTER LOOP\r\n VERTEX -0 0 0\r\n"
      "VERTEX 1.0e0 +1 0\r\n VERTEX 0 1 0\r\n ENDLOOP\r\n ENDFACET\r\n";
  const TriangleSoup soup =
      ReadStl("square.stl",
              "solid a square of two facets\n" + (kFacet + other) +
                  "endsolid a square\n");
  EXPECT_EQ(soup.points.rows(), 4);
  EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
}

TEST(StlIo, AFileMayHoldSeveralSolids) {
  const std::string solid = std::string("solid\n") + kFacet + "endsolid\n";
  EXPECT_EQ(TextOf(ReadStl("a.stl", solid + solid).triangles), "0 1 2 0 1 2");
}

TEST(StlIo, BinaryMayStartWithSolid) {
  const std::string bytes = StlBytes(UnitTetrahedron());
  const TriangleSoup soup = ReadStl("b.stl", "solid" + bytes.substr(5));
  EXPECT_EQ(soup.points.rows(), 4);
  EXPECT_EQ(soup.triangles.rows(), 4);
}

TEST(StlIo, AWordOutOfPlaceIsQuotedWithItsLine) {
  ExpectInputError(
      [] {
        ReadStl("a.stl",
                With(std::string("solid a\n") + kFacet, "loop", "lop"));
      },
      {"a.stl: line 3", "'lop'", "'loop'"});
}

TEST(StlIo, ATruncatedFileSaysHowFarItGoes) {
  ExpectInputError([] { ReadStl("a.stl", std::string("solid a\n") + kFacet); },
                   {"a.stl", "is truncated", "after 1 facets", "'endsolid'"});
  // 84 + 4 * 50 bytes, of which one is missing.
  std::string bytes = StlBytes(UnitTetrahedron());
  bytes.pop_back();
  ExpectInputError([&] { ReadStl("a.stl", bytes); },
                   {"promises 284 bytes", "has 283"});
}

// Would take 200 gigabytes if the header were believed.
TEST(StlIo, AnAbsurdCountIsRefused) {
  std::string bytes = StlBytes(UnitTetrahedron());
  bytes.replace(80, 4, "\xff\xff\xff\xff");
  ExpectInputError([&] { ReadStl("a.stl", bytes); },
                   {"a.stl", "promises 214748364834 bytes"});
}

TEST(StlIo, NoFacetsAreRefused) {
  ExpectInputError([] { ReadStl("a.stl", "solid a\nendsolid a\n"); },
                   {"no faces"});
}

TEST(StlIo, BytesBehindTheFacetsAreSkippedWithANote) {
  const TriangleSoup sphere = Icosphere(100, 1);
  const std::string bytes = StlBytes(sphere);
  std::vector<std::string> notes;
  const TriangleSoup plain = ReadStl("a.stl", bytes, &notes);
  EXPECT_TRUE(notes.empty());
  const TriangleSoup read =
      ReadStl("a.stl", bytes + std::string(7, 'x'), &notes);
  EXPECT_TRUE(SameBits(read, plain));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "a.stl: the last 7 bytes were skipped: they follow the " +
                std::to_string(sphere.triangles.rows()) +
                " facets that its header promises");
}

}  // namespace
}  // namespace musclewarp
