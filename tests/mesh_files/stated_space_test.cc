// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/stated_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The header of a binary .stl file with this text.
std::string StlHeader(std::string text) {
  text.resize(80, ' ');
  return text + std::string(4, '\0');
}

// What 3D Slicer writes.
TEST(StatedSpace, IsFoundWhereSlicerWritesIt) {
  for (const std::string space : {"LPS", "RAS"}) {
    const std::string text = "3D Slicer output. SPACE=" + space;
    EXPECT_EQ(StatedSpaceIn(".stl", StlHeader(text)), space);
    EXPECT_EQ(StatedSpaceIn(".stl", "solid " + text + "\n facet"), space);
    EXPECT_EQ(
        StatedSpaceIn(".obj", "# " + text + "\n\nmtllib a.mtl\nv 1 2 3\n"),
        space);
    EXPECT_EQ(StatedSpaceIn(".ply",
                            "ply\nformat ascii 1.0\ncomment VTK generated PLY "
                            "File\nobj_info vtkPolyData\ncomment SPACE=" +
                                space + "\nelement vertex 3\n"),
              space);
    const std::string vtk = "# vtk DataFile Version 4.2\n";
    EXPECT_EQ(StatedSpaceIn(".vtk", vtk + text + "\nASCII\n"), space);
    const std::string field =
        vtk + "a title\nASCII\nFIELD FieldData 1\nSPACE 1 1 string\n";
    EXPECT_EQ(StatedSpaceIn(".vtk", field + space + "\n\nPOINTS 3"), space);
    EXPECT_EQ(StatedSpaceIn(".vtk", field + "\xc3" + space + "\nPOINTS 3"),
              space);
  }
}

TEST(StatedSpace, IsNotFoundElsewhere) {
  EXPECT_EQ(StatedSpaceIn(".stl", "solid a\nSPACE=LPS"), "");
  EXPECT_EQ(StatedSpaceIn(".stl", StlHeader("a") + "SPACE=LPS"), "");
  EXPECT_EQ(StatedSpaceIn(".stl", StlHeader("SPACE=LPSX")), "");
  EXPECT_EQ(StatedSpaceIn(".stl", StlHeader("SPACE=scanner")), "");
  EXPECT_EQ(StatedSpaceIn(".stl", StlHeader("SPACE=LPS;COLOR=rgba")), "LPS");
  EXPECT_EQ(StatedSpaceIn(".obj", "v 1 2 3\n# SPACE=LPS\n"), "");
  EXPECT_EQ(StatedSpaceIn(".ply", "ply\nend_header\ncomment SPACE=LPS\n"), "");
  EXPECT_EQ(StatedSpaceIn(".off", "OFF\n# SPACE=LPS\n"), "");
  for (const std::string extension :
       {".stl", ".obj", ".ply", ".vtk", ".vtp", ".off"}) {
    EXPECT_EQ(StatedSpaceIn(extension, ""), "") << extension;
  }
  EXPECT_EQ(StatedSpace("/no/such/file.stl"), "");
}

TEST(StatedSpace, OurOwnFilesStateNone) {
  for (const std::string extension : {"ply", "obj", "off", "stl", "vtk"}) {
    const std::string file = TestTempDir() + "/a." + extension;
    WriteTriangleSoup(file, UnitTetrahedron());
    EXPECT_EQ(StatedSpace(file), "") << extension;
  }
}

TEST(StatedSpace, OfAPartIsThatOfItsFile) {
  const std::string file = TestTempDir() + "/a.obj";
  WriteTextAtomically(file, "# SPACE=RAS\no psoas\nv 1 2 3\n");
  EXPECT_EQ(StatedSpace(file + "#psoas"), "RAS");
}

TEST(CommonSpace, FilesThatAgreeStayAndNothingIsSaid) {
  for (const std::string space : {"", "LPS", "RAS"}) {
    const CommonSpace common =
        FindCommonSpace({{"a", space}, {"b", ""}, {"c", space}});
    EXPECT_THAT(common.is_turned, ElementsAre(false, false, false));
    EXPECT_THAT(common.warnings, ElementsAre());
  }
}

TEST(CommonSpace, OthersAreTurnedToTheFirst) {
  const CommonSpace common = FindCommonSpace(
      {{"a.ply", ""}, {"b.stl", "RAS"}, {"c.stl", "LPS"}, {"d.stl", "RAS"}});
  EXPECT_THAT(common.is_turned, ElementsAre(false, false, true, false));
  EXPECT_THAT(common.warnings,
              ElementsAre(AllOf(HasSubstr("c.stl states the space LPS"),
                                HasSubstr("b.stl RAS"),
                                HasSubstr("in RAS")),
                          AllOf(HasSubstr("a.ply states no space"),
                                HasSubstr("taken as it is, in RAS"))));
}

TEST(CommonSpace, AxesDecideAmongFilesThatDiffer) {
  const std::vector<StatedFile> files = {{"b.stl", "RAS"}, {"c.stl", "LPS"}};
  EXPECT_THAT(FindCommonSpace(files, "LPS", "a.json").is_turned,
              ElementsAre(true, false));
  // Axes of another kind do not.
  EXPECT_THAT(FindCommonSpace(files, "ASR", "a.json").is_turned,
              ElementsAre(false, true));
}

TEST(CommonSpace, AxesThatAllContradictAreNamed) {
  for (const std::string axes : {"LPS", "ASR"}) {
    const CommonSpace common = FindCommonSpace(
        {{"a.stl", "RAS"}, {"b.stl", "RAS"}}, axes, "a.json: axes");
    EXPECT_THAT(common.is_turned, ElementsAre(false, false));
    EXPECT_THAT(common.warnings,
                ElementsAre(AllOf(HasSubstr("a.stl, b.stl state the space RAS"),
                                  HasSubstr("a.json: axes says " + axes))));
  }
  EXPECT_THAT(FindCommonSpace({{"a.stl", "RAS"}}, "RAS", "a.json").warnings,
              ElementsAre());
}

TEST(TurnToOtherSpace, TwiceIsNothing) {
  const Points points = Icosphere(10, 1).points;
  Points turned = points;
  TurnToOtherSpace(&turned);
  EXPECT_EQ(turned.col(0), -points.col(0));
  EXPECT_EQ(turned.col(1), -points.col(1));
  EXPECT_EQ(turned.col(2), points.col(2));
  TurnToOtherSpace(&turned);
  EXPECT_EQ(turned, points);
}

}  // namespace
}  // namespace musclewarp
