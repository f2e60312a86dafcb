// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Model Read(const std::string& text) {
  return ReadModel(Written("leg.osim", text));
}

void ExpectRefused(const std::string& text, std::vector<std::string> words) {
  words.push_back("leg.osim");
  ExpectInputError([&] { Read(text); }, words);
}

std::string Replaced(std::string text,
                     const std::string& from,
                     const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const std::string Knee() { return Model4(Joint4("PinJoint", "q")); }

std::string WithMuscle(const std::string& point) {
  return Model4(Joint4("PinJoint", "q"),
                "",
                Muscle("m", Point4("p1", "thigh", "0 0 0") + point));
}

TEST(ModelReader, ReadsBothVersions) {
  for (const std::string& text : {Knee(), Model3()}) {
    const Model model = Read(text);
    EXPECT_EQ(model.name, "leg");
    ASSERT_EQ(model.bodies.size(), 3u);
    EXPECT_EQ(model.bodies[0].name, "ground");
    EXPECT_EQ(model.FindBody("shank"), 2);
    EXPECT_EQ(model.FindBody("foot"), -1);
    EXPECT_EQ(model.joints.size(), 2u);
    EXPECT_THAT(model.warnings, IsEmpty());
  }
}

TEST(ModelReader, CoordinateKindsFollowFromTheAxes) {
  const std::string identity =
      "<LinearFunction><coefficients>1 0</coefficients></LinearFunction>";
  const std::string spline = "<SimmSpline><x>0 1</x><y>0 2</y></SimmSpline>";
  const Model model = Read(Model4(Joint4(
      "CustomJoint",
      "turn move both",
      SpatialTransform(Axis4("turn", "0 0 1", identity) +
                       Axis4("both", "1 0 0", spline) + FreeAxes(2, 3) +
                       Axis4("move", "1 0 0", identity) +
                       Axis4("turn", "0 1 0", spline) + FreeAxes(5, 6)))));
  EXPECT_EQ(model.coordinates[0].kind, CoordinateKind::kRotational);
  EXPECT_EQ(model.coordinates[1].kind, CoordinateKind::kTranslational);
  EXPECT_EQ(model.coordinates[2].kind, CoordinateKind::kCoupled);
}

TEST(ModelReader, Latin1UnderAUtf8HeadIsReadWithAWarning) {
  const Model model = Read(Replaced(Knee(),
                                    "<Ground name=",
                                    "<credits>Universit\xe9</credits>"
                                    "<Ground name="));
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_THAT(model.warnings[0], HasSubstr("Latin-1"));
}

TEST(ModelReader, NamesOnceWhatItDoesNotFollow) {
  std::string muscle = Muscle(
      "m1", Point4("a", "thigh", "0 0 0") + Point4("b", "shank", "0 0 0"));
  muscle = Replaced(muscle,
                    "</PathPointSet>",
                    "</PathPointSet><PathWrapSet><objects><PathWrap/>"
                    "</objects></PathWrapSet>");
  const Model model =
      Read(Model4(Joint4("PinJoint", "q"),
                  "<PointConstraint name=\"c1\"/><WeldConstraint name=\"c2\"/>",
                  muscle + Replaced(muscle, "m1", "m2")));
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_THAT(model.warnings[0], HasSubstr("PointConstraint \"c1\", Weld"));
  EXPECT_THAT(model.warnings[1], HasSubstr("m1, m2"));
}

TEST(ModelReader, GeometryComesWithItsScaleAndPlace) {
  const Model three =
      Read(Replaced(Model3(),
                    "<Body name=\"thigh\">",
                    R"(<Body name="thigh"><VisibleObject><GeometrySet><objects>
         <DisplayGeometry><geometry_file>.\geo\a.vtp</geometry_file>
         <transform>0 0 0 0.5 0 0</transform>
         <scale_factors>2 2 2</scale_factors></DisplayGeometry>
         </objects></GeometrySet><scale_factors>0.001 0.001 0.002</scale_factors>
         </VisibleObject>)"));
  ASSERT_EQ(three.bodies[1].geometry.size(), 1u);
  const ModelGeometry& geometry = three.bodies[1].geometry[0];
  EXPECT_EQ(geometry.file, "./geo/a.vtp");
  EXPECT_EQ(geometry.scale, Eigen::Vector3d(0.002, 0.002, 0.004));
  EXPECT_EQ(geometry.body_from_mesh(0, 3), 500);

  const std::string mesh =
      "<attached_geometry><Mesh><mesh_file>b.stl</mesh_file>"
      "<scale_factors>1 1 -1</scale_factors></Mesh></attached_geometry>";
  const Model four =
      Read(Replaced(Replaced(Knee(),
                             "<Body name=\"thigh\"/>",
                             "<Body name=\"thigh\">" + mesh + "</Body>"),
                    "<translation>0 -0.4 0</translation>",
                    "<translation>0 -0.4 0</translation>" + mesh));
  ASSERT_EQ(four.bodies[1].geometry.size(), 2u);
  EXPECT_EQ(four.bodies[1].geometry[0].scale[2], -1);
  EXPECT_EQ(four.bodies[1].geometry[1].body_from_mesh(1, 3), -400);
}

TEST(ModelReader, RefusesXmlThatIsCutShort) {
  const std::string text = Knee();
  ExpectRefused(text.substr(0, text.size() / 2), {"line", "well-formed"});
  ExpectRefused("time\n1\n", {"well-formed"});
  ExpectRefused("<OpenSimDocument/>", {"no <Model>"});
}

TEST(ModelReader, RefusesACircleOfBodies) {
  ExpectRefused(Replaced(Replaced(Knee(),
                                  "<socket_parent_frame>/ground",
                                  "<socket_parent_frame>/bodyset/shank"),
                         "<Ground name=\"ground\"/>",
                         ""),
                {"body", "its own parent"});
}

TEST(ModelReader, RefusesNamesThatNothingHas) {
  ExpectRefused(Replaced(Knee(),
                         "/bodyset/shank</socket_parent>",
                         "/bodyset/foot<"
                         "/socket_parent>"),
                {"line", "socket_parent", "/bodyset/foot"});
  ExpectRefused(Replaced(Model3(), "<parent_body>thigh", "<parent_body>hip"),
                {"line", "parent_body", "\"hip\""});
  ExpectRefused(WithMuscle(Point4("p2", "foot", "0 0 0")), {"/bodyset/foot"});
  ExpectRefused(WithMuscle(Point4("p2",
                                  "shank",
                                  "0 0 0",
                                  "ConditionalPathPoint",
                                  "<socket_coordinate>hip</socket_coordinate>"
                                  "<range>0 1</range>")),
                {"socket_coordinate", "\"hip\""});
}

TEST(ModelReader, RefusesValuesThatAreNone) {
  ExpectRefused(WithMuscle(Point4("p2", "shank", "0 NaN 0")),
                {"line", "<location>", "'NaN'"});
  ExpectRefused(WithMuscle(Point4("p2", "shank", "0 0")),
                {"<location>", "2 numbers", "give 3"});
  ExpectRefused(Model4(Joint4("UniversalJoint", "q q")),
                {"\"q\" a second time"});
}

TEST(ModelReader, RefusesFunctionsThatAreNotSound) {
  const auto custom = [](const std::string& function) {
    return Model4(Joint4(
        "CustomJoint",
        "q",
        SpatialTransform(Axis4("q", "0 0 1", function) + FreeAxes(1, 6))));
  };
  ExpectRefused(custom("<SimmSpline><x>0 1 1</x><y>0 1 2</y></SimmSpline>"),
                {"line", "SimmSpline", "do not rise"});
  ExpectRefused(custom("<SimmSpline><x>0 1</x><y>0 1 2</y></SimmSpline>"),
                {"2 x and 3 y"});
  ExpectRefused(custom("<LinearFunction><coefficients>1 2 3</coefficients>"
                       "</LinearFunction>"),
                {"2 arguments", "1 coordinates"});
  ExpectRefused(custom("<LinearFunction/>"), {"no <coefficients>"});
}

}  // namespace
}  // namespace musclewarp
