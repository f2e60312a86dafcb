// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/vtp_reader.h"
#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

TEST(VtpWriter, KeepsEveryBit) {
  EXPECT_TRUE(SameBits(ReadVtp("a.vtp", VtpOfMesh(HardSoup())), HardSoup()));
}

TEST(VtpWriter, WritesTheSameBytesAgain) {
  const std::vector<NamedField> fields = {{"x", HardSoup().points.col(0)},
                                          {"all", HardSoup().points}};
  EXPECT_EQ(VtpOfMesh(HardSoup(), fields), VtpOfMesh(HardSoup(), fields));
}

TEST(VtpWriter, FieldsAreNamedAndDoNotDisturbTheMesh) {
  const std::string bytes = VtpOfMesh(HardSoup(),
                                      {{"height", HardSoup().points.col(2)},
                                       {"displacement", HardSoup().points}});
  EXPECT_THAT(bytes, HasSubstr("Name=\"height\""));
  EXPECT_THAT(bytes,
              HasSubstr("Name=\"displacement\" NumberOfComponents=\"3\""));
  EXPECT_TRUE(SameBits(ReadVtp("a.vtp", bytes), HardSoup()));
}

TEST(VtpWriter, LinesShareNoPoints) {
  const Points line = RandomPoints(5, 1);
  const std::string bytes =
      VtpOfLines({line, line.topRows(3)}, {{"length", Eigen::Vector2d(1, 2)}});
  EXPECT_THAT(bytes, HasSubstr("NumberOfPoints=\"8\""));
  EXPECT_THAT(bytes, HasSubstr("NumberOfLines=\"2\""));
  EXPECT_THAT(bytes, HasSubstr("Name=\"length\""));
  // Lines are no faces.
  ExpectInputError([&] { ReadVtp("a.vtp", bytes); }, {"no faces (8 vertices)"});
}

TEST(VtpWriterDeathTest, AFieldOfAnotherLengthIsAProgrammerError) {
  EXPECT_DEATH(
      VtpOfMesh(UnitTetrahedron(), {{"short", Eigen::Vector3d(1, 2, 3)}}),
      "short");
}

}  // namespace
}  // namespace musclewarp
