// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/joint_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

const char kIdentity[] =
    "<LinearFunction><coefficients>1 0</coefficients></LinearFunction>";
const char kSpline[] = "<SimmSpline><x>0 1</x><y>0 2</y></SimmSpline>";

// A model whose knee has the function as its first rotation, about z.
std::string CustomModel(const std::string& function,
                        const std::string& axis = "0 0 1",
                        const std::string& coordinates = "q") {
  return Model4(Joint4(
      "CustomJoint",
      "q",
      SpatialTransform(Axis4(coordinates, axis, function) + FreeAxes(1, 6))));
}

const Joint& Knee(const Model& model) {
  return model.joints[model.bodies[kShank].joint];
}

TEST(JointReader, CoordinateKindsFollowFromTheAxes) {
  const Model model = ReadText(Model4(Joint4(
      "CustomJoint",
      "turn move both",
      SpatialTransform(Axis4("turn", "0 0 1", kIdentity) +
                       Axis4("both", "1 0 0", kSpline) + FreeAxes(2, 3) +
                       Axis4("move", "1 0 0", kIdentity) +
                       Axis4("turn", "0 1 0", kSpline) + FreeAxes(5, 6)))));
  EXPECT_EQ(model.coordinates[0].kind, CoordinateKind::kRotational);
  EXPECT_EQ(model.coordinates[1].kind, CoordinateKind::kTranslational);
  EXPECT_EQ(model.coordinates[2].kind, CoordinateKind::kCoupled);
}

TEST(JointReader, AStatedKindHasPrecedenceOverTheAxes) {
  for (const auto& [type, kind] :
       {std::pair<std::string, CoordinateKind>{"rotational",
                                               CoordinateKind::kRotational},
        {"Translational", CoordinateKind::kTranslational},
        {"coupled", CoordinateKind::kCoupled}}) {
    const Model model =
        ReadText(Replaced(CustomModel(kIdentity),
                          "<Coordinate name=\"q\"/>",
                          "<Coordinate name=\"q\"><motion_type>" + type +
                              "</motion_type></Coordinate>"));
    EXPECT_EQ(model.coordinates[0].kind, kind) << type;
  }
}

TEST(JointReader, AxesHaveUnitLengthAndTranslationsAreInMillimetres) {
  const Model model = ReadText(Model4(
      Joint4("CustomJoint",
             "q",
             SpatialTransform(FreeAxes(0, 3) + Axis4("q", "0 -4 0", kIdentity) +
                              FreeAxes(4, 6)))));
  const TransformAxis& axis = Knee(model).translations[0];
  EXPECT_EQ(axis.axis, Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(axis.coordinates, std::vector<int>{0});
  EXPECT_EQ(axis.function->Value({0.25}), 250);
}

TEST(JointReader, CoordinatesThatAreNotWrittenHaveNamesAndDefaults) {
  const Model model = ReadText(Model4(Joint4("UniversalJoint", "a")));
  ASSERT_EQ(model.coordinates.size(), 2u);
  EXPECT_EQ(model.coordinates[0].name, "a");
  EXPECT_EQ(model.coordinates[1].name, "knee_joint_coord_1");
  EXPECT_EQ(model.coordinates[1].default_value, 0);
}

TEST(JointReader, PlacesOfOpenSim3AreThoseOfTheElements) {
  const Model model = ReadText(Replaced(
      Model3(),
      "<location_in_parent>0 -0.4 0</location_in_parent>\n"
      "     <orientation_in_parent>0 0 0</orientation_in_parent>\n"
      "     <location>0 0 0</location><orientation>0 0 0</orientation>",
      "<location_in_parent>0.1 0 0</location_in_parent>"
      "<orientation_in_parent>0 0 0.2</orientation_in_parent>"
      "<location>0 0.3 0</location><orientation>0.4 0 0</orientation>"));
  EXPECT_EQ(Knee(model).parent_from_joint,
            OffsetTransform({0.1, 0, 0}, {0, 0, 0.2}));
  EXPECT_EQ(Knee(model).child_from_joint,
            OffsetTransform({0, 0.3, 0}, {0.4, 0, 0}));
  EXPECT_EQ(Knee(model).parent, 1);
  EXPECT_EQ(Knee(model).child, kShank);
}

TEST(JointReader, UnknownTypesAndFunctionsAreNoted) {
  const Model ellipsoid = ReadText(Model4(Joint4("EllipsoidJoint", "q")));
  EXPECT_THAT(Knee(ellipsoid).unsupported,
              HasSubstr("the type of joint in line"));
  EXPECT_EQ(ellipsoid.FindCoordinate("q"), 0);
  const Model spline = ReadText(CustomModel("<GCVSpline/>"));
  EXPECT_THAT(Knee(spline).unsupported,
              HasSubstr("the function <GCVSpline> in line"));
}

TEST(JointReader, ABodyWithTwoJointsIsAClosedLoop) {
  std::string second = Joint4("WeldJoint", "");
  second = Replaced(second, "knee_joint", "loop");
  const Model model = ReadText(Model4(Joint4("PinJoint", "q") + second));
  EXPECT_EQ(Knee(model).name, "knee_joint");
  EXPECT_THAT(Knee(model).unsupported,
              HasSubstr("a closed loop: joint \"loop"));
}

TEST(JointReader, RefusesNamesThatNothingHas) {
  ExpectRefused(Replaced(Model3(), "<parent_body>thigh", "<parent_body>hip"),
                {"line", "parent_body", "\"hip\""});
  ExpectRefused(CustomModel(kIdentity, "0 0 1", "r"),
                {"line", "<coordinates>", "\"r\""});
}

TEST(JointReader, RefusesTwoCoordinatesOfOneName) {
  ExpectRefused(Model4(Joint4("UniversalJoint", "q q")),
                {"line", "second coordinate", "\"q\""});
}

TEST(JointReader, RefusesAFunctionThatIsNotThatOfItsAxis) {
  for (const char* function :
       {"<LinearFunction><coefficients>1 0</coefficients></LinearFunction>",
        "<Constant name=\"f\"><value>1</value></Constant>",
        "<SimmSpline/>"}) {
    std::string text = CustomModel(kIdentity);
    const auto begin = text.find("<function>");
    ASSERT_NE(begin, std::string::npos);
    const auto end = text.find("</function>", begin);
    text.replace(begin, end + 11 - begin, function);
    ExpectRefused(text, {"line", "not named as the function of its axis"});
  }
}

TEST(JointReader, ReadsRanges) {
  std::string joint = Joint4("PinJoint", "q");
  const std::string plain = "<Coordinate name=\"q\"";
  const auto at = joint.find(plain);
  ASSERT_NE(at, std::string::npos);
  const auto end = joint.find('>', at);
  ASSERT_EQ(joint[end - 1], '/');
  joint.replace(
      end - 1, 2, "><range>-1.5 2</range><clamped>true</clamped></Coordinate>");
  const Model model = ReadText(Model4(joint));
  ASSERT_TRUE(model.coordinates[0].range);
  EXPECT_EQ((*model.coordinates[0].range)[0], -1.5);
  EXPECT_EQ((*model.coordinates[0].range)[1], 2);
  EXPECT_TRUE(model.coordinates[0].is_clamped);
  EXPECT_FALSE(ReadText(PinModel()).coordinates[0].range);
}

TEST(JointReader, RefusesAxesThatAreNotComplete) {
  ExpectRefused(CustomModel(kIdentity, "0 0 0"), {"line", "no axis"});
  ExpectRefused(CustomModel("<LinearFunction><coefficients>1 2 "
                            "3</coefficients></LinearFunction>"),
                {"2 arguments", "1 coordinates"});
  ExpectRefused(
      Model4(Joint4("CustomJoint", "q", SpatialTransform(FreeAxes(0, 5)))),
      {"5 <TransformAxis>", "3 rotations and 3 translations"});
  ExpectRefused(Model4(Joint4("CustomJoint", "q")), {"no <SpatialTransform>"});
}

}  // namespace
}  // namespace musclewarp
