// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "musclewarp/mesh_files/binary_scalar.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

std::string WrittenFile(const std::string& name, const std::string& bytes) {
  const std::string path = TestTempDir() + "/" + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string BytesOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TriangleSoup SoupFromBytes(const std::string& name, const std::string& bytes) {
  return ReadTriangleSoup(WrittenFile(name, bytes));
}

// Corners that need all 17 digits, the ends of the range of double, both zeros,
// a point no face uses, two equal points and a face without area.
TriangleSoup HardSoup() {
  TriangleSoup soup = Icosphere(100, 1);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-1, 1);
  for (double& x : soup.points.reshaped()) x += jitter(random);
  soup.points.row(0) << 0.1, 1.0 / 3, -2.0 / 3;
  soup.points.row(1) << 4.9406564584124654e-324, -2.2250738585072009e-308,
      1.7976931348623157e308;
  soup.points.row(2) << 0.0, -0.0, 123456789.12345679;
  soup.points.row(3) = soup.points.row(4);
  soup.points.conservativeResize(soup.points.rows() + 1, 3);
  soup.points.bottomRows(1) << 1, 2, 3;
  soup.triangles.row(0) << 5, 5, 6;
  return soup;
}

// Bit for bit: tells 0 from -0.
bool SameBits(const TriangleSoup& a, const TriangleSoup& b) {
  return a.points.rows() == b.points.rows() &&
         a.triangles.rows() == b.triangles.rows() &&
         std::memcmp(a.points.data(),
                     b.points.data(),
                     a.points.size() * sizeof(double)) == 0 &&
         (a.triangles.array() == b.triangles.array()).all();
}

constexpr char kTwoTriangles[] = "0 1 2 0 2 3";

std::string TextOf(const Triangles& triangles) {
  std::ostringstream text;
  const Eigen::IOFormat format(
      Eigen::StreamPrecision, Eigen::DontAlignCols, " ", " ");
  text << triangles.format(format);
  return text.str();
}

class MeshIoFormat : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshIoFormat, KeepsEveryBitOfASoup) {
  const std::string path = TestTempDir() + "/soup" + GetParam();
  const TriangleSoup soup = HardSoup();
  WriteTriangleSoup(path, soup);
  EXPECT_TRUE(SameBits(ReadTriangleSoup(path), soup));
}

TEST_P(MeshIoFormat, WritesTheSameBytesAgain) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a" + GetParam(), HardSoup());
  WriteTriangleSoup(dir + "/b" + GetParam(), HardSoup());
  EXPECT_EQ(BytesOf(dir + "/a" + GetParam()), BytesOf(dir + "/b" + GetParam()));
}

TEST_P(MeshIoFormat, IsChosenByExtensionInAnyCase) {
  const std::string extension = GetParam();
  std::string upper = extension;
  for (char& c : upper) c = std::toupper(c);
  EXPECT_TRUE(IsMeshExtension(extension));
  EXPECT_TRUE(IsMeshExtension(extension.substr(1)));
  EXPECT_TRUE(IsMeshExtension(upper));
  const std::string path = TestTempDir() + "/a.b" + upper;
  WriteTriangleSoup(path, UnitTetrahedron());
  EXPECT_TRUE(SameBits(ReadTriangleSoup(path), UnitTetrahedron()));
}

INSTANTIATE_TEST_SUITE_P(Double,
                         MeshIoFormat,
                         ::testing::Values(".ply",
                                           ".obj",
                                           ".off",
                                           ".vtk"
#ifdef MUSCLEWARP_WITH_VTK
                                           ,
                                           ".vtp"
#endif
                                           ),
                         [](const auto& test) {
                           return std::string(test.param + 1);
                         });

TEST(MeshIo, OtherExtensionsAreNoMeshes) {
  for (const char* extension : {"", ".", ".txt", "png", ".pl", ".plyx"}) {
    EXPECT_FALSE(IsMeshExtension(extension)) << extension;
  }
  EXPECT_TRUE(IsMeshExtension(".STL"));
#ifndef MUSCLEWARP_WITH_VTK
  EXPECT_FALSE(IsMeshExtension(".vtp"));
#endif
}

TEST(MeshIo, StlKeepsFacetsAndMergesEqualCorners) {
  const std::string path = TestTempDir() + "/sphere.stl";
  TriangleSoup sphere = Icosphere(10, 2);
  sphere.points = sphere.points.cast<float>().cast<double>();
  WriteTriangleSoup(path, sphere);
  const TriangleSoup read = ReadTriangleSoup(path);
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

TEST(MeshIo, AsciiStlReadsLikeBinaryStl) {
  const std::string facet1 =
      "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n"
      "      vertex 1 0 0\n      vertex 1 1 0\n    endloop\n  endfacet\n";
  const std::string facet2 =
      "  FACET NORMAL nan nan nan\r\n    OUTER LOOP\r\n VERTEX -0 0 0\r\n"
      "VERTEX 1.0e0 +1 0\r\n VERTEX 0 1 0\r\n ENDLOOP\r\n ENDFACET\r\n";
  const TriangleSoup soup =
      SoupFromBytes("square.stl",
                    "solid a square of two facets\n" + facet1 + facet2 +
                        "endsolid a square\n");
  EXPECT_EQ(soup.points.rows(), 4);
  EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
}

TEST(MeshIo, BinaryStlMayStartWithSolid) {
  const std::string path = TestTempDir() + "/a.stl";
  WriteTriangleSoup(path, UnitTetrahedron());
  const std::string bytes = BytesOf(path);
  const TriangleSoup soup = SoupFromBytes("b.stl", "solid" + bytes.substr(5));
  EXPECT_EQ(soup.points.rows(), 4);
  EXPECT_EQ(soup.triangles.rows(), 4);
}

TEST(MeshIo, AsciiPlySkipsWhatItDoesNotKnow) {
  const TriangleSoup soup = SoupFromBytes("square.ply",
                                          "ply\r\n"
                                          "format ascii 1.0\r\n"
                                          "comment made by hand\r\n"
                                          "element camera 1\r\n"
                                          "property list uchar float view\r\n"
                                          "element vertex 4\r\n"
                                          "property uchar red\r\n"
                                          "property float z\r\n"
                                          "property double x\r\n"
                                          "property double y\r\n"
                                          "element face 1\r\n"
                                          "property int flags\r\n"
                                          "property list uint8 uint32 "
                                          "vertex_index\r\n"
                                          "element nothing 3\r\n"
                                          "end_header\r\n"
                                          "2 0.5 0.25\r\n"
                                          "255 9 0 0\r\n"
                                          "255 9 0.10000000000000001 0\r\n"
                                          "255 9 1 1\r\n"
                                          "\r\n"
                                          "255 9 0 1\r\n"
                                          "7 4 0 1 2 3\r\n");
  EXPECT_EQ(soup.points.row(1), Eigen::RowVector3d(0.1, 0, 9));
  EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
}

class BinaryPly : public ::testing::TestWithParam<ByteOrder> {};

TEST_P(BinaryPly, ReadsFloatsAndSkipsExtraProperties) {
  const ByteOrder order = GetParam();
  std::string bytes = "ply\nformat binary_" +
                      std::string(order == ByteOrder::kBig ? "big" : "little") +
                      "_endian 1.0\n"
                      "element vertex 4\n"
                      "property float x\nproperty float y\nproperty float z\n"
                      "property double quality\n"
                      "element face 1\n"
                      "property list uchar float texcoord\n"
                      "property list ushort short vertex_indices\n"
                      "property uchar red\n"
                      "end_header\n";
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    AppendBytes<float>(0.1f + x, order, &bytes);
    AppendBytes<float>(y, order, &bytes);
    AppendBytes<float>(-2.5f, order, &bytes);
    AppendBytes<double>(1e9, order, &bytes);
  }
  AppendBytes<std::uint8_t>(1, order, &bytes);
  AppendBytes<float>(0.5f, order, &bytes);
  AppendBytes<std::uint16_t>(4, order, &bytes);
  for (const int v : {0, 1, 2, 3}) AppendBytes<std::int16_t>(v, order, &bytes);
  AppendBytes<std::uint8_t>(255, order, &bytes);
  const TriangleSoup soup = SoupFromBytes("square.ply", bytes);
  EXPECT_EQ(soup.points.row(1), Eigen::RowVector3d(0.1f + 1, 0, -2.5));
  EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
}

INSTANTIATE_TEST_SUITE_P(Orders,
                         BinaryPly,
                         ::testing::Values(ByteOrder::kLittle, ByteOrder::kBig),
                         [](const auto& test) {
                           return test.param == ByteOrder::kBig ? "Big"
                                                                : "Little";
                         });

TEST(MeshIo, ObjReadsEveryFormOfCorner) {
  const TriangleSoup soup = SoupFromBytes("square.obj",
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

TEST(MeshIo, OffReadsHeadersAndColours) {
  for (const char* header :
       {"OFF 4 2 0\n", "OFF\n# comment\n4 2 5\n", "COFF\n4 2\n"}) {
    const TriangleSoup soup =
        SoupFromBytes("square.off",
                      std::string(header) +
                          "0 0 0 255 0 0 255\n1 0 0\n\n1 1 0 # third\n0 1 0\n"
                          "3 0 1 2 0.5 0.5 0.5\n3 0 2 3\n");
    EXPECT_EQ(soup.points.rows(), 4);
    EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
  }
}

TEST(MeshIo, AConcavePolygonIsSplitWithoutFolds) {
  // An arrow head: only the fans of corners 0 and 2 stay inside, and the face
  // starts with corner 1.
  const TriangleSoup soup = SoupFromBytes(
      "arrow.off", "OFF 4 1 0\n0 0 0\n4 -4 0\n1 0 0\n4 4 0\n4 1 2 3 0\n");
  ASSERT_EQ(soup.triangles.rows(), 2);
  double area = 0;
  for (int f = 0; f < 2; ++f) {
    const Eigen::RowVector3d a = soup.points.row(soup.triangles(f, 0));
    const Eigen::RowVector3d b = soup.points.row(soup.triangles(f, 1));
    const Eigen::RowVector3d c = soup.points.row(soup.triangles(f, 2));
    const double twice = (b - a).cross(c - a).z();
    EXPECT_GT(twice, 0) << soup.triangles.row(f);
    area += twice / 2;
  }
  EXPECT_EQ(area, 4);
}

TEST(MeshIo, AsciiLegacyVtkReadsPolygonsAndStrips) {
  const TriangleSoup soup =
      SoupFromBytes("strips.vtk",
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

TEST(MeshIo, LegacyVtkOfVersion5Reads) {
  std::string bytes =
      "# vtk DataFile Version 5.1\nvtk output\nBINARY\nDATASET POLYDATA\n"
      "POINTS 4 float\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
    AppendBytes<float>(x, ByteOrder::kBig, &bytes);
  }
  bytes += "\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n";
  for (const int x : {0, 4}) {
    AppendBytes<std::int64_t>(x, ByteOrder::kBig, &bytes);
  }
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const int x : {0, 1, 2, 3}) {
    AppendBytes<std::int64_t>(x, ByteOrder::kBig, &bytes);
  }
  EXPECT_EQ(TextOf(SoupFromBytes("a.vtk", bytes + "\n").triangles),
            kTwoTriangles);
}

#ifdef MUSCLEWARP_WITH_VTK
TEST(MeshIo, VtpReadsPolygonsStripsAndPieces) {
  const std::string points =
      "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
      "format=\"ascii\">0 0 0 1 0 0 0.10000000000000001 1 0 1 1 0</DataArray>"
      "</Points>";
  const auto cells = [](const std::string& name,
                        const std::string& corners,
                        const std::string& offset) {
    return "<" + name + "><DataArray type=\"Int32\" Name=\"connectivity\" " +
           "format=\"ascii\">" + corners + "</DataArray>" +
           "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" +
           offset + "</DataArray></" + name + ">";
  };
  const auto file = [](const std::string& pieces) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" "
           "version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>" +
           pieces + "</PolyData></VTKFile>\n";
  };
  const std::string polygon =
      "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\">" + points +
      cells("Polys", "0 1 3 2", "4") + "</Piece>";
  const std::string strip =
      "<Piece NumberOfPoints=\"4\" NumberOfStrips=\"1\">" + points +
      cells("Strips", "0 1 2 3", "4") + "</Piece>";
  const TriangleSoup soup = SoupFromBytes("a.vtp", file(polygon + polygon));
  ASSERT_EQ(soup.points.rows(), 8);
  EXPECT_EQ(soup.points.row(2), Eigen::RowVector3d(0.1, 1, 0));
  EXPECT_EQ(TextOf(soup.triangles), "0 1 3 0 3 2 4 5 7 4 7 6");
  EXPECT_EQ(TextOf(SoupFromBytes("a.vtp", file(strip)).triangles),
            "0 1 2 2 1 3");
  EXPECT_EQ(TextOf(SoupFromBytes("a.vtp", file(polygon + strip)).triangles),
            "0 1 3 0 3 2 4 5 6 6 5 7");
  // The first piece to hold polygons need not be the first piece.
  const std::string bare = "<Piece NumberOfPoints=\"4\">" + points + "</Piece>";
  EXPECT_EQ(TextOf(SoupFromBytes("a.vtp", file(bare + polygon)).triangles),
            "4 5 7 4 7 6");
}

// Plain bytes behind an underscore, in either byte order, each array with its
// size before it.
TEST(MeshIo, VtpReadsAppendedData) {
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
    const TriangleSoup soup = SoupFromBytes(
        "a.vtp",
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
#endif

}  // namespace
}  // namespace musclewarp
