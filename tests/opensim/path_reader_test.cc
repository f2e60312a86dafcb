// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/path_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

std::string Conditional(const std::string& type,
                        const std::string& coordinate,
                        const std::string& range) {
  return Point4("p2",
                "shank",
                "0 0 0",
                type,
                "<socket_coordinate>" + coordinate + "</socket_coordinate>" +
                    "<range>" + range + "</range>");
}

std::string Moving(const std::string& x_location) {
  return "<MovingPathPoint name=\"p2\">"
         "<socket_parent_frame>/bodyset/shank</socket_parent_frame>"
         "<socket_x_coordinate>/jointset/knee_joint/q</socket_x_coordinate>" +
         x_location +
         "<y_location><Constant><value>-0.1</value></Constant></y_location>"
         "<z_location><Constant><value>0</value></Constant></z_location>"
         "</MovingPathPoint>";
}

std::string XLocation(const std::string& function) {
  return "<x_location>" + function + "</x_location>";
}

std::string Linear(const std::string& coefficients) {
  return "<LinearFunction><coefficients>" + coefficients +
         "</coefficients></LinearFunction>";
}

PathPoint SecondPoint(const std::string& point) {
  const Model model = ReadText(PinModelWithPoint(point));
  EXPECT_EQ(model.muscles[0].unsupported, "");
  return model.muscles[0].path.at(1);
}

TEST(PathReader, BothVersionsHaveTheSamePoints) {
  const auto point3 = [](const std::string& name,
                         const std::string& body,
                         const std::string& location,
                         const std::string& type) {
    return "<" + type + " name=\"" + name + "\"><body>" + body +
           "</body><location>" + location + "</location></" + type + ">";
  };
  const std::string four = Model4(Joint4("PinJoint", "q"),
                                  "",
                                  Muscle("m",
                                         Point4("a", "thigh", "0.01 0 0") +
                                             Point4("b", "shank", "0 0.02 0")));
  const std::string three =
      Model3("",
             Muscle("m",
                    point3("a", "thigh", "0.01 0 0", "PathPoint") +
                        point3("b", "shank", "0 0.02 0", "MusclePoint")));
  for (const std::string& text : {four, three}) {
    const Model model = ReadText(text);
    ASSERT_EQ(model.muscles.size(), 1u);
    EXPECT_EQ(model.muscles[0].name, "m");
    const std::vector<PathPoint>& path = model.muscles[0].path;
    ASSERT_EQ(path.size(), 2u);
    EXPECT_EQ(path[0].name, "a");
    EXPECT_EQ(path[0].body, 1);
    EXPECT_EQ(path[0].location, Eigen::Vector3d(10, 0, 0));
    EXPECT_EQ(path[1].body, 2);
    EXPECT_EQ(path[1].location, Eigen::Vector3d(0, 20, 0));
    EXPECT_FALSE(path[1].is_moving);
    EXPECT_EQ(path[1].condition, -1);
  }
}

TEST(PathReader, PointsOnOffsetFramesAreOnTheBody) {
  const PathPoint point = SecondPoint(
      "<PathPoint name=\"p2\"><socket_parent_frame>"
      "/jointset/knee_joint/thigh_offset</socket_parent_frame>"
      "<location>0.1 0 0</location></PathPoint>");
  EXPECT_EQ(point.body, 1);
  EXPECT_EQ(point.location, Eigen::Vector3d(100, -400, 0));
}

TEST(PathReader, ConditionalPointsHaveACoordinateAndARange) {
  for (const std::string type : {"ConditionalPathPoint", "MuscleViaPoint"}) {
    const PathPoint point = SecondPoint(Conditional(type, "q", "-1 0.5"));
    EXPECT_EQ(point.condition, 0);
    EXPECT_EQ(point.range[0], -1);
    EXPECT_EQ(point.range[1], 0.5);
  }
}

TEST(PathReader, MovingPointsAreInMillimetres) {
  const PathPoint point = SecondPoint(Moving(XLocation(Linear("0.01 0.03"))));
  EXPECT_TRUE(point.is_moving);
  EXPECT_EQ(point.moving_coordinates, (std::array<int, 3>{0, -1, -1}));
  // 1000 (0.01 * 2 + 0.03), up to rounding of these three numbers.
  EXPECT_DOUBLE_EQ(point.moving_functions[0]->Value({2}), 50);
  EXPECT_EQ(point.moving_functions[1]->Value({}), -100);
}

TEST(PathReader, UnknownKindsAreNoted) {
  const auto unsupported = [](const std::string& point) {
    return ReadText(PinModelWithPoint(point)).muscles[0].unsupported;
  };
  EXPECT_THAT(unsupported(Point4("p2", "shank", "0 0 0", "OtherPoint")),
              HasSubstr("the path point <OtherPoint> in line"));
  EXPECT_THAT(unsupported(Moving(XLocation("<GCVSpline/>"))),
              HasSubstr("<GCVSpline> in line"));
  EXPECT_THAT(unsupported(Point4("p2", "foot", "0 0 0")),
              HasSubstr("the frame \"/bodyset/foot\" in line"));
}

TEST(PathReader, PathsOfOtherForcesAreFound) {
  const OsimXml four = Xml("<Ligament><path><GeometryPath/></path></Ligament>");
  EXPECT_TRUE(GeometryPathOf(four.root()));
  const OsimXml three = Xml("<Ligament><GeometryPath/></Ligament>");
  EXPECT_TRUE(GeometryPathOf(three.root()));
  const OsimXml none = Xml("<CoordinateActuator/>");
  EXPECT_FALSE(GeometryPathOf(none.root()));
}

TEST(PathReader, RefusesNamesThatNothingHas) {
  ExpectRefused(
      PinModelWithPoint(Conditional("ConditionalPathPoint", "hip", "0 1")),
      {"socket_coordinate", "\"hip\""});
}

TEST(PathReader, RefusesValuesThatAreNone) {
  ExpectRefused(PinModelWithPoint(Point4("p2", "shank", "0 NaN 0")),
                {"line", "<location>", "'NaN'"});
  ExpectRefused(PinModelWithPoint(Point4("p2", "shank", "0 0")),
                {"<location>", "2 numbers", "give 3"});
  ExpectRefused(
      PinModelWithPoint(Conditional("ConditionalPathPoint", "q", "0")),
      {"<range>", "1 numbers", "give 2"});
  ExpectRefused(PinModelWithPoint(Moving("")), {"no <x_location>"});
  ExpectRefused(PinModelWithPoint(Moving(XLocation(Linear("1 2 3")))),
                {"2 arguments", "function of one"});
}

TEST(PathReader, RefusesAPathOfOnePoint) {
  ExpectRefused(PinModelWithPoint(""), {"1 path points", "at least 2"});
}

}  // namespace
}  // namespace musclewarp
