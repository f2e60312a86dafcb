// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/off_io.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/binary_scalar.h"
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

// The square as the plain file has it.
void ExpectOffSquare(const std::string& bytes) {
  EXPECT_TRUE(SameBits(ReadOff("b.off", bytes), ReadOff("a.off", kOffSquare)))
      << bytes;
}

TEST(OffIo, RecordsMayGoOnOnTheNextLine) {
  ExpectOffSquare(With(kOffSquare, "3 0 1 2", "3 0\n1 2"));
  ExpectOffSquare(With(kOffSquare, "3 0 1 2", "3\n0 1 2 0.5 0.5 0.5"));
  ExpectOffSquare(With(kOffSquare, "1 1 0\n", "1\n1\n0\n"));
  ExpectOffSquare(
      "CNOFF\n4 2 0\n0 0 0 0 0 1\n9 9 9 9\n1 0 0 0 0 1\n9 9 9\n"
      "1 1 0 0 0 1 9 9 9\n0 1 0 0 0 1 9 9 9 9\n3 0 1 2\n3 0 2 3\n");
}

TEST(OffIo, RecordsMayShareALine) {
  ExpectOffSquare("OFF 4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2 3 0 2 3\n");
  ExpectOffSquare("OFF\n4 2 0\n0 0 0 1 0 0 1 1 0 0 1 0 3 0 1\n2 3 0 2 3");
  ExpectOffSquare(
      "NOFF\n4 2 0\n0 0 0 0 0 1 1 0 0 0 0 1\n1 1 0 0 0 1 0 1 0 0 0 1\n"
      "3 0 1 2 3 0 2 3\n");
}

TEST(OffIo, TheKeywordNamesWhatIsSkipped) {
  for (const char* keyword : {"NOFF", "CNOFF", "STOFF", "STCNOFF", "COFF"}) {
    ExpectOffSquare(With(kOffSquare, "OFF", keyword));
  }
  ExpectOffSquare(With(kOffSquare, "OFF\n", ""));
  ExpectOffRefusal("OFF", "4OFF", {"a.off", "'4OFF'", "three coordinates"});
}

// The square with `header`, `behind` numbers behind each vertex, and colours of
// 0 and 4 numbers on its faces.
std::string BinaryOffSquare(const std::string& header, int behind) {
  std::string bytes = header;
  const auto whole = [&](std::int32_t number) {
    AppendBytes<std::int32_t>(number, ByteOrder::kBig, &bytes);
  };
  const auto real = [&](float number) {
    AppendBytes<float>(number, ByteOrder::kBig, &bytes);
  };
  for (const int count : {4, 2, 0}) whole(count);
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    for (const int number : {x, y, 0}) real(static_cast<float>(number));
    for (int i = 0; i < behind; ++i) real(0.5F);
  }
  for (const int number : {3, 0, 1, 2, 0, 3, 0, 2, 3, 4}) whole(number);
  for (int i = 0; i < 4; ++i) real(0.5F);
  return bytes;
}

TEST(OffIo, ReadsBinaryFiles) {
  ExpectOffSquare(BinaryOffSquare("OFF BINARY\n", 0));
  ExpectOffSquare(BinaryOffSquare("OFF BINARY\r\n", 0));
  ExpectOffSquare(BinaryOffSquare("NOFF BINARY\n", 3));
  ExpectOffSquare(BinaryOffSquare("STCNOFF BINARY\n", 9));
}

TEST(OffIo, ATruncatedBinaryFileIsRefused) {
  const std::string bytes = BinaryOffSquare("OFF BINARY\n", 0);
  for (std::size_t size = 11; size < bytes.size(); ++size) {
    ExpectInputError([&] { ReadOff("a.off", bytes.substr(0, size)); },
                     {"a.off: is truncated"});
  }
  ExpectInputError([&] { ReadOff("a.off", bytes + "more"); },
                   {"less than the file holds"});
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
