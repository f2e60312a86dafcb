// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/ply_io.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr char kPlySquare[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty double z\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

void ExpectPlyRefusal(const std::string& bytes,
                      const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadPly("a.ply", bytes); }, words);
}

TEST(PlyIo, KeepsEveryBit) {
  EXPECT_TRUE(SameBits(ReadPly("a.ply", PlyBytes(HardSoup())), HardSoup()));
}

TEST(PlyIo, AsciiSkipsWhatItDoesNotKnow) {
  const TriangleSoup soup = ReadPly("square.ply",
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
  const TriangleSoup soup = ReadPly("square.ply", bytes);
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

// Two strips of a band of triangles, whose first runs the same way as the
// faces.
TEST(PlyIo, StripsAreFaces) {
  const std::string header =
      "element vertex 5\nproperty float x\nproperty float y\n"
      "property float z\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  const TriangleSoup faces =
      ReadPly("faces.ply",
              "ply\nformat ascii 1.0\n" + header +
                  "element face 3\nproperty list uchar int vertex_indices\n"
                  "end_header\n" +
                  points + "3 0 1 2\n3 2 1 3\n3 2 3 4\n");
  const std::string strips =
      "element tristrips 1\nproperty list int int vertex_indices\n"
      "end_header\n";
  for (const char* list :
       {"8 0 1 2 3 -1 2 3 4\n", "9 0 1 2 3 -1\n2 3 4 -1\n"}) {
    EXPECT_TRUE(SameBits(
        faces,
        ReadPly("strips.ply",
                "ply\nformat ascii 1.0\n" + header + strips + points + list)))
        << list;
  }
  for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig}) {
    std::string bytes =
        "ply\nformat binary_" +
        std::string(order == ByteOrder::kBig ? "big" : "little") +
        "_endian 1.0\n" + header + strips;
    for (const double x : faces.points.reshaped<Eigen::RowMajor>()) {
      AppendBytes<float>(static_cast<float>(x), order, &bytes);
    }
    for (const int v : {8, 0, 1, 2, 3, -1, 2, 3, 4}) {
      AppendBytes<std::int32_t>(v, order, &bytes);
    }
    EXPECT_TRUE(SameBits(faces, ReadPly("strips.ply", bytes)));
  }
}

TEST(PlyIo, ItemsMayGoOnOnTheNextLineOrShareOne) {
  const TriangleSoup square = ReadPly("a.ply", kPlySquare);
  EXPECT_TRUE(SameBits(
      square, ReadPly("b.ply", With(kPlySquare, "3 0 1 2", "3\n0 1\n2"))));
  EXPECT_TRUE(SameBits(
      square,
      ReadPly("b.ply", With(kPlySquare, "0 0 0\n1 0 0\n", "0 0 0 1 0 0\n"))));
}

TEST(PlyIo, TheHeaderMustNotPromiseLess) {
  ExpectPlyRefusal(With(kPlySquare, "face 2", "face 1"),
                   {"line 15", "less than the file holds"});
  ExpectPlyRefusal(PlyBytes(UnitTetrahedron()) + "more",
                   {"less than the file holds"});
}

// Would take tens of gigabytes if the header were believed.
TEST(PlyIo, AbsurdCountsAreRefused) {
  const std::string bytes = PlyBytes(UnitTetrahedron());
  ExpectPlyRefusal(With(bytes, "vertex 4", "vertex 4000000000"),
                   {"promises 4000000000 of element 'vertex'"});
  ExpectPlyRefusal(With(bytes, "face 4", "face 4000000000"),
                   {"promises 4000000000 of element 'face'"});
}

TEST(PlyIo, MissingPropertiesAreNamed) {
  ExpectPlyRefusal(With(kPlySquare, "double y", "double w"),
                   {"a.ply", "without"});
  ExpectPlyRefusal(With(kPlySquare, "vertex_indices", "corners"),
                   {"a.ply", "without", "vertex_indices"});
}

TEST(PlyIo, ALineMustHoldWhatTheHeaderSays) {
  ExpectPlyRefusal(With(kPlySquare, "1 1 0\n", "1 1 0 7\n"),
                   {"line 12", "more values (4)"});
  ExpectPlyRefusal(With(kPlySquare, "1 1 0\n", "1 1\n"),
                   {"line 12", "fewer values (2)"});
  ExpectPlyRefusal(With(kPlySquare, "3 0 1 2\n", "-3 0 1 2\n"),
                   {"item 0", "'vertex_indices'", "length -3"});
}

}  // namespace
}  // namespace musclewarp
