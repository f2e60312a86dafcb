// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/geometry_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

std::string AttachedMesh() {
  return "<attached_geometry><Mesh><mesh_file>b.stl</mesh_file>"
         "<scale_factors>1 1 -1</scale_factors></Mesh></attached_geometry>";
}

TEST(GeometryReader, ScalesAndPlacesOfOpenSim3AreMultiplied) {
  const OsimXml xml = Xml(R"(<Body name="thigh"><VisibleObject>
      <GeometrySet><objects>
       <DisplayGeometry><geometry_file>.\geo\a.vtp</geometry_file>
        <transform>0 0 0 0.5 0 0</transform>
        <scale_factors>2 2 2</scale_factors></DisplayGeometry>
       <DisplayGeometry><geometry_file/></DisplayGeometry>
      </objects></GeometrySet>
      <scale_factors>0.001 0.001 0.002</scale_factors>
      <transform>0 0 0 0 0.25 0</transform>
     </VisibleObject></Body>)");
  const auto geometry = ReadBodyGeometry(xml, xml.root());
  // The one without a file is left out.
  ASSERT_EQ(geometry.size(), 1u);
  EXPECT_EQ(geometry[0].file, "./geo/a.vtp");
  EXPECT_EQ(geometry[0].scale, Eigen::Vector3d(0.002, 0.002, 0.004));
  EXPECT_EQ(geometry[0].body_from_mesh,
            OffsetTransform({0.5, 0.25, 0}, Eigen::Vector3d::Zero()));
}

TEST(GeometryReader, MeshesOfOpenSim4LieInTheFrameOfTheBody) {
  const OsimXml xml = Xml("<Body name=\"thigh\">" + AttachedMesh() + "</Body>");
  const auto geometry = ReadBodyGeometry(xml, xml.root());
  ASSERT_EQ(geometry.size(), 1u);
  EXPECT_EQ(geometry[0].file, "b.stl");
  EXPECT_EQ(geometry[0].scale, Eigen::Vector3d(1, 1, -1));
  EXPECT_TRUE(geometry[0].body_from_mesh.isIdentity(0));
}

TEST(GeometryReader, MeshesOnOffsetFramesBelongToTheBodyBelow) {
  const Model model = ReadText(
      Replaced(PinModel(),
               "<translation>0 -0.4 0</translation>",
               "<translation>0 -0.4 0</translation>" + AttachedMesh()));
  ASSERT_EQ(model.bodies[1].geometry.size(), 1u);
  EXPECT_EQ(model.bodies[1].geometry[0].body_from_mesh(1, 3), -400);
  EXPECT_TRUE(model.bodies[2].geometry.empty());
}

TEST(GeometryReader, TheGroundMayHaveMeshes) {
  const std::string three = R"(<VisibleObject><GeometrySet><objects>
      <DisplayGeometry><geometry_file>b.stl</geometry_file></DisplayGeometry>
      </objects></GeometrySet></VisibleObject>)";
  for (const std::string& text :
       {Replaced(PinModel(),
                 "<Ground name=\"ground\"/>",
                 "<Ground name=\"ground\">" + AttachedMesh() + "</Ground>"),
        Replaced(Model3(), "<Joint/>", "<Joint/>" + three)}) {
    const Model model = ReadText(text);
    ASSERT_EQ(model.bodies[0].geometry.size(), 1u);
    EXPECT_EQ(model.bodies[0].geometry[0].file, "b.stl");
  }
}

TEST(GeometryReader, RefusesScalesThatAreNotThreeNumbers) {
  const OsimXml xml = Xml(Replaced(
      "<Body name=\"thigh\">" + AttachedMesh() + "</Body>", "1 1 -1", "1 1"));
  ExpectInputError([&] { ReadBodyGeometry(xml, xml.root()); },
                   {"part.osim", "<scale_factors>", "2 numbers", "give 3"});
}

}  // namespace
}  // namespace musclewarp
