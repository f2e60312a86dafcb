// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/vtp_writer.h"
#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr char kPoints[] =
    "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
    "format=\"ascii\">0 0 0 1 0 0 0.10000000000000001 1 0 1 1 0</DataArray>"
    "</Points>";

// The section "Polys" or "Strips" of a piece, as text.
std::string Cells(const std::string& name,
                  const std::string& corners,
                  const std::string& ends) {
  return "<" + name + "><DataArray type=\"Int32\" Name=\"connectivity\" " +
         "format=\"ascii\">" + corners + "</DataArray>" +
         "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" + ends +
         "</DataArray></" + name + ">";
}

std::string File(const std::string& pieces) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" "
         "version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>" +
         pieces + "</PolyData></VTKFile>\n";
}

std::string PolygonPiece() {
  return std::string("<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\">") +
         kPoints + Cells("Polys", "0 1 3 2", "4") + "</Piece>";
}

std::string StripPiece() {
  return std::string("<Piece NumberOfPoints=\"4\" NumberOfStrips=\"1\">") +
         kPoints + Cells("Strips", "0 1 2 3", "4") + "</Piece>";
}

std::string TrianglesOf(const std::string& pieces) {
  return TextOf(ReadVtp("a.vtp", File(pieces)).triangles);
}

void ExpectVtpRefusal(const std::string& bytes,
                      const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadVtp("a.vtp", bytes); }, words);
}

TEST(VtpReader, ReadsPolygonsAndStrips) {
  const TriangleSoup soup = ReadVtp("a.vtp", File(PolygonPiece()));
  EXPECT_EQ(soup.points.row(2), Eigen::RowVector3d(0.1, 1, 0));
  EXPECT_EQ(TextOf(soup.triangles), "0 1 3 0 3 2");
  EXPECT_EQ(TrianglesOf(StripPiece()), "0 1 2 2 1 3");
}

TEST(VtpReader, CornersOfAPieceCountFromItsFirstPoint) {
  EXPECT_EQ(TrianglesOf(PolygonPiece() + PolygonPiece()),
            "0 1 3 0 3 2 4 5 7 4 7 6");
  EXPECT_EQ(TrianglesOf(PolygonPiece() + StripPiece()),
            "0 1 3 0 3 2 4 5 6 6 5 7");
  // The first piece to hold polygons need not be the first piece.
  const std::string bare =
      std::string("<Piece NumberOfPoints=\"4\">") + kPoints + "</Piece>";
  EXPECT_EQ(TrianglesOf(bare + PolygonPiece()), "4 5 7 4 7 6");
}

// Plain bytes behind an underscore, in either byte order, each array with its
// size before it.
TEST(VtpReader, ReadsAppendedData) {
  for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig}) {
    std::string data;
    AppendBytes<std::uint64_t>(12 * sizeof(float), order, &data);
    for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
      AppendBytes<float>(x, order, &data);
    }
    AppendBytes<std::uint64_t>(4 * sizeof(std::int64_t), order, &data);
    for (const int x : {0, 1, 2, 3}) AppendBytes<std::int64_t>(x, order, &data);
    AppendBytes<std::uint64_t>(sizeof(std::uint8_t), order, &data);
    AppendBytes<std::uint8_t>(4, order, &data);
    const std::string name =
        order == ByteOrder::kBig ? "BigEndian" : "LittleEndian";
    const TriangleSoup soup =
        ReadVtp("a.vtp",
                "<VTKFile type='PolyData' byte_order='" + name +
                    "' header_type='UInt64'><!-- <Piece> --><PolyData>"
                    "<Piece NumberOfPoints='4' NumberOfPolys='1'>"
                    "<PointData/><Points><DataArray type='Float32' "
                    "format='appended' offset='0'/></Points><Polys>"
                    "<DataArray type='Int64' Name='connectivity' "
                    "format='appended' offset='56'/>"
                    "<DataArray type='UInt8' Name='offsets' format='appended' "
                    "offset='96'/></Polys></Piece></PolyData>"
                    "<AppendedData encoding='raw'>\n_" +
                    data + "\n</AppendedData></VTKFile>");
    EXPECT_EQ(soup.points.row(2), Eigen::RowVector3d(1, 1, 0));
    EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
  }
}

TEST(VtpReader, AFileThatContradictsItselfIsRefused) {
  const std::string vtp = VtpOfMesh(UnitTetrahedron());
  ExpectVtpRefusal(With(vtp, "<Polys>", "<Polis>"),
                   {"'/Polys' closes 'Polis'"});
  ExpectVtpRefusal(With(vtp, "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\""),
                   {"holds 12 numbers, 15 are promised"});
  ExpectVtpRefusal(With(vtp, "NumberOfPolys=\"4\"", "NumberOfPolys=\"3\""),
                   {"holds 4 numbers, 3 are promised"});
  ExpectVtpRefusal(With(vtp, "NumberOfPoints=\"4\"", "NumberOfPoints=\"-1\""),
                   {"NumberOfPoints is '-1'"});
  ExpectVtpRefusal(With(vtp, "\"PolyData\"", "\"UnstructuredGrid\""),
                   {"only VTKFile of type PolyData"});
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  ExpectVtpRefusal(With(vtp, "<Polys>", deep + "<Polys>"),
                   {"more than 1000 deep"});
  // Would take a hundred gigabytes if it were believed.
  ExpectVtpRefusal(
      With(vtp, "NumberOfPoints=\"4\"", "NumberOfPoints=\"4000000000\""),
      {"12000000000 are promised"});
}

TEST(VtpReader, CellsThatDoNotFitAreRefused) {
  const auto file = [](const std::string& corners, const std::string& ends) {
    return File(
        "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"2\"><Points>"
        "<DataArray type=\"Float64\" format=\"ascii\">"
        "0 0 0 1 0 0 0 1 0</DataArray></Points>" +
        Cells("Polys", corners, ends) + "</Piece>");
  };
  EXPECT_EQ(TextOf(ReadVtp("a.vtp", file("0 1 2 2 1 0", "3 6")).triangles),
            "0 1 2 2 1 0");
  ExpectVtpRefusal(file("0 1 2 2 1 0", "6 3"), {"offset 1 is 3 after 6"});
  ExpectVtpRefusal(file("0 1 2 2 1 0", "3 4611686018427387904"),
                   {"holds 6 numbers, 4611686018427387904 are promised"});
  ExpectVtpRefusal(file("0 1 2 2 1 3", "3 6"), {"face 1", "vertex 3"});
  ExpectVtpRefusal(file("0 1 2 2 1", "3 5"), {"face 1", "2 corners"});
  ExpectVtpRefusal(With(file("0 1 2 2 1 0", "3 6"), "1 0 0", "1 nan 0"),
                   {"vertex 1", "must be finite"});
}

// A vertex of another piece would be there, but is not meant.
TEST(VtpReader, CornersMustBeInTheirOwnPiece) {
  ExpectVtpRefusal(
      File(PolygonPiece() + With(PolygonPiece(), "0 1 3 2", "0 1 3 4")),
      {"piece 1", "names vertex 4", "the piece has 4"});
}

}  // namespace
}  // namespace musclewarp
