// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "musclewarp/opensim/model.h"
#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Coupler(const std::string& independents,
                    const std::string& dependent,
                    const std::string& function) {
  return "<CoordinateCouplerConstraint name=\"c\">"
         "<coupled_coordinates_function>" +
         function +
         "</coupled_coordinates_function><independent_coordinate_names>" +
         independents +
         "</independent_coordinate_names><dependent_coordinate_name>" +
         dependent +
         "</dependent_coordinate_name></CoordinateCouplerConstraint>";
}

TEST(ModelReader, ReadsBothVersions) {
  for (const std::string& text : {PinModel(), Model3()}) {
    const Model model = ReadText(text);
    EXPECT_EQ(model.name, "leg");
    ASSERT_EQ(model.bodies.size(), 3u);
    EXPECT_EQ(model.bodies[0].name, "ground");
    EXPECT_EQ(model.bodies[1].name, "thigh");
    EXPECT_EQ(model.bodies[2].name, "shank");
    EXPECT_EQ(model.joints.size(), 2u);
    EXPECT_EQ(model.joints[model.bodies[2].joint].parent, 1);
    EXPECT_EQ(model.bodies[0].joint, -1);
    EXPECT_THAT(model.warnings, IsEmpty());
  }
}

TEST(ModelReader, WarningsOfTheXmlAreKept) {
  const Model model = ReadText(Replaced(PinModel(),
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
  const Model model = ReadText(
      Model4(Joint4("PinJoint", "q"),
             "<PointConstraint name=\"c1\"/><WeldConstraint name=\"c2\"/>",
             muscle + Replaced(muscle, "m1", "m2")));
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_THAT(model.warnings[0], HasSubstr("PointConstraint \"c1\", Weld"));
  EXPECT_THAT(model.warnings[1], HasSubstr("m1, m2"));
}

TEST(ModelReader, ForcesWithoutAPathAreNoMuscles) {
  const Model model =
      ReadText(Model4(Joint4("PinJoint", "q"),
                      "",
                      "<CoordinateActuator name=\"motor\"/>" +
                          Muscle("m",
                                 Point4("a", "thigh", "0 0 0") +
                                     Point4("b", "shank", "0 0 0"))));
  ASSERT_EQ(model.muscles.size(), 1u);
  EXPECT_EQ(model.muscles[0].name, "m");
}

TEST(ModelReader, ReadsCouplers) {
  const Model model =
      ReadText(Model4(Joint4("UniversalJoint", "a b"),
                      Coupler("/jointset/knee_joint/a",
                              "b",
                              "<LinearFunction><coefficients>2 1</coefficients>"
                              "</LinearFunction>")));
  ASSERT_EQ(model.couplers.size(), 1u);
  const CoordinateCoupler& coupler = model.couplers[0];
  EXPECT_EQ(coupler.independents, std::vector<int>{0});
  EXPECT_EQ(coupler.dependent, 1);
  EXPECT_EQ(coupler.scale, 1);
  EXPECT_EQ(coupler.function->Value({3}), 7);
}

TEST(ModelReader, ACouplerOfAnUnknownKindMakesItsJointsUnsupported) {
  const Model model = ReadText(Model4(Joint4("UniversalJoint", "a b"),
                                      Coupler("a", "b", "<GCVSpline/>")));
  EXPECT_THAT(model.couplers, IsEmpty());
  EXPECT_THAT(model.joints[model.bodies[2].joint].unsupported,
              HasSubstr("constraint \"c\" with <GCVSpline> in line"));
}

TEST(ModelReader, RefusesCouplersThatAreNotValid) {
  const auto refuse = [](const std::string& coupler,
                         const std::vector<std::string>& words) {
    ExpectRefused(Model4(Joint4("UniversalJoint", "a b"), coupler), words);
  };
  const std::string constant = "<Constant><value>1</value></Constant>";
  refuse(Coupler("a", "c", constant), {"dependent_coordinate_name", "\"c\""});
  refuse(Coupler("a", "", constant), {"names 0 coordinates"});
  refuse(Coupler("a", "b", ""), {"no <coupled_coordinates_function>"});
  refuse(Coupler("a",
                 "b",
                 "<LinearFunction><coefficients>1 2 3</coefficients>"
                 "</LinearFunction>"),
         {"more arguments than independent coordinates"});
}

TEST(ModelReader, RefusesXmlThatIsNoModel) {
  ExpectRefused("<OpenSimDocument/>", {"no element <Model>"});
}

TEST(ModelReader, RefusesTwoBodiesOfOneName) {
  ExpectRefused(
      Replaced(PinModel(), "<Body name=\"shank\"/>", "<Body name=\"thigh\"/>"),
      {"line", "<Body name=\"thigh\">", "second body"});
}

TEST(ModelReader, RefusesACircleOfBodies) {
  ExpectRefused(Replaced(Replaced(PinModel(),
                                  "<socket_parent_frame>/ground",
                                  "<socket_parent_frame>/bodyset/shank"),
                         "<Ground name=\"ground\"/>",
                         ""),
                {"body", "its own parent"});
}

}  // namespace
}  // namespace musclewarp
