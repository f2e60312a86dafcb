// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/off_io.h"

#include <gtest/gtest.h>

#include "mesh_files/format_checks.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

constexpr char kOffSquare[] =
    "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

void ExpectOffRefusal(const std::string& old_part,
                      const std::string& new_part,
                      const std::vector<std::string>& words) {
  ExpectInputError(
      [&] { ReadOff("a.off", With(kOffSquare, old_part, new_part)); }, words);
}

TEST(OffIo, KeepsEveryBit) {
  EXPECT_TRUE(SameBits(ReadOff("a.off", OffBytes(HardSoup())), HardSoup()));
}

TEST(OffIo, ReadsHeadersAndColours) {
  for (const char* header :
       {"OFF 4 2 0\n", "OFF\n# comment\n4 2 5\n", "COFF\n4 2\n"}) {
    const TriangleSoup soup =
        ReadOff("square.off",
                std::string(header) +
                    "0 0 0 255 0 0 255\n1 0 0\n\n1 1 0 # third\n0 1 0\n"
                    "3 0 1 2 0.5 0.5 0.5\n3 0 2 3\n");
    EXPECT_EQ(soup.points.rows(), 4);
    EXPECT_EQ(TextOf(soup.triangles), kTwoTriangles);
  }
}

TEST(OffIo, BinaryFilesAreRefused) {
  ExpectOffRefusal("OFF", "OFF BINARY", {"a.off", "is not an ASCII OFF file"});
}

TEST(OffIo, TheHeaderMustNotPromiseLess) {
  ExpectOffRefusal("4 2 0", "4 1 0", {"line 8", "less than the file holds"});
}

TEST(OffIo, ATruncatedFileSaysHowFarItGoes) {
  ExpectOffRefusal(
      "3 0 2 3\n", "", {"is truncated", "promises 2 faces", "ends after 1"});
  ExpectOffRefusal(
      "4 2 0", "4", {"is truncated", "numbers of vertices and faces"});
}

TEST(OffIo, CountsMustNotBeNegative) {
  ExpectOffRefusal("4 2 0", "4 -2 0", {"line 2", "is negative"});
}

// Would take tens of gigabytes if the header were believed.
TEST(OffIo, AbsurdCountsAreRefused) {
  ExpectOffRefusal("4 2 0", "4000000000 2 0", {"a.off"});
  ExpectOffRefusal("4 2 0",
                   "4 4000000000 0",
                   {"promises 4000000000 faces, the file ends after 2"});
}

TEST(OffIo, AFaceWithFewerCornersThanItSaysIsRefused) {
  ExpectOffRefusal("3 0 2 3", "4 0 2 3", {"line 8", "has 4 values"});
}

}  // namespace
}  // namespace musclewarp
