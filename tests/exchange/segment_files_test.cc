// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/segment_files.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <sstream>

#include "musclewarp/base/input_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

SegmentSoup Corner() {
  SegmentSoup curve;
  curve.points.resize(3, 3);
  curve.points << 0.1, 0, 0, 1.0 / 3, 0, 0, 1, 2, 3;
  curve.segments.resize(2, 2);
  curve.segments << 0, 1, 1, 2;
  return curve;
}

TEST(WriteSegments, ObjKeepsEveryBit) {
  const std::string path = TestTempDir() + "/a.obj";
  WriteSegments(path, Corner());
  std::istringstream in(ReadFile(path));
  std::string word;
  for (int i = 0; i < 3; ++i) {
    Eigen::RowVector3d p;
    in >> word >> p[0] >> p[1] >> p[2];
    EXPECT_EQ(word, "v");
    EXPECT_EQ(p, Corner().points.row(i));
  }
  int i = 0, k = 0;
  in >> word >> i >> k;
  EXPECT_EQ(word, "l");
  EXPECT_EQ(i, 1);
  EXPECT_EQ(k, 2);
}

TEST(WriteSegments, PlyHasEdges) {
  const std::string path = TestTempDir() + "/a.ply";
  WriteSegments(path, Corner());
  const std::string bytes = ReadFile(path);
  const size_t body = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size(), body + 9 * sizeof(double) + 4 * sizeof(int32_t));
  double third = 0;
  std::memcpy(&third, &bytes[body + 3 * sizeof(double)], sizeof(third));
  EXPECT_EQ(third, 1.0 / 3);
  std::int32_t last = 0;
  std::memcpy(&last, &bytes[bytes.size() - sizeof(last)], sizeof(last));
  EXPECT_EQ(last, 2);
}

#ifdef MUSCLEWARP_WITH_VTK
TEST(WriteSegments, VtpHasLines) {
  const std::string path = TestTempDir() + "/a.vtp";
  WriteSegments(path, Corner());
  EXPECT_NE(ReadFile(path).find("NumberOfLines=\"2\""), std::string::npos);
}
#endif

}  // namespace
}  // namespace musclewarp
