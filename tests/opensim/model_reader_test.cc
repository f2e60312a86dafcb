// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "musclewarp/opensim/kinematics.h"
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

std::string ModelOfBodies(size_t count) {
  std::string bodies;
  for (size_t i = 0; i < count; ++i) {
    bodies += "<Body name=\"b" + std::to_string(i) + "\"/>";
  }
  return "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><BodySet>"
         "<objects>" +
         bodies + "</objects></BodySet></Model></OpenSimDocument>";
}

TEST(ModelReader, AModelHasALargestNumberOfParts) {
  EXPECT_EQ(ReadText(ModelOfBodies(kMostModelParts)).bodies.size(),
            kMostModelParts + 1);  // and the ground
  ExpectRefused(ModelOfBodies(kMostModelParts + 1),
                {"has 5001 bodies", "at most 5000"});
}

TEST(ModelReader, TellsCoordinatesOfOneNameApartByTheirJoints) {
  // A further joint between ground and shank, of the same coordinates.
  const std::string second =
      Replaced(Joint4("BallJoint", "rx ry q"), "knee_joint", "loop");
  const Model model =
      ReadText(Model4(Joint4("BallJoint", "rx ry rz") + second));
  ASSERT_EQ(model.coordinates.size(), 6u);
  EXPECT_EQ(model.coordinates[0].name, "knee_joint/rx");
  EXPECT_EQ(model.coordinates[2].name, "rz");
  EXPECT_EQ(model.coordinates[3].name, "loop/rx");
  EXPECT_EQ(model.coordinates[5].name, "q");
  EXPECT_EQ(model.joints[2].rotations[1].coordinates[0], 4);
}

TEST(ModelReader, SaysThatOnlyOneOfTwoMusclesOfOneNameIsUsed) {
  const std::string muscle = Muscle(
      "m", Point4("a", "thigh", "0 0 0") + Point4("b", "shank", "0 0 0"));
  const Model model =
      ReadText(Model4(Joint4("PinJoint", "q"), "", muscle + muscle));
  EXPECT_EQ(model.muscles.size(), 1u);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_THAT(model.warnings[0], HasSubstr("further one of the name \"m\""));
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

// Returns the frame of the shank, on which everything above it has an effect.
Eigen::Matrix4d ShankFrame(const Model& model) {
  CoordinateValues values = DefaultValues(model);
  values[0] = 0.5;
  return BodyFrames(model, values)[kShank];
}

TEST(ModelReader, PartsWithoutANameAreRead) {
  std::string text = PinModel();
  for (const char* name : {" name=\"hip\"", " name=\"knee_joint\""}) {
    text = Replaced(text, name, " name=\"\"");
  }
  const Model model = ReadText(text);
  ASSERT_EQ(model.joints.size(), 2u);
  EXPECT_EQ(model.joints[0].name, "weldjoint");
  EXPECT_EQ(model.joints[1].name, "pinjoint");
  ExpectNear(ShankFrame(model), ShankFrame(ReadText(PinModel())));
  // The coordinate of a pin is then named after its joint.
  const Model nameless =
      ReadText(Replaced(text, "<Coordinate name=\"q\"/>", "<Coordinate/>"));
  EXPECT_EQ(nameless.coordinates[0].name, "pinjoint_coord_0");
}

TEST(ModelReader, BetasOfOpenSim4HaveConnectors) {
  const auto connector = [](const std::string& name, const std::string& path) {
    return "<Connector_PhysicalFrame_ name=\"" + name + "\"><connectee_name>" +
           path + "</connectee_name></Connector_PhysicalFrame_>";
  };
  std::string text = PinModel();
  text =
      Replaced(text,
               "<socket_parent_frame>thigh_offset</socket_parent_frame>",
               "<connectors>" + connector("parent_frame", "thigh_offset") +
                   connector("child_frame", "shank_offset") + "</connectors>");
  text = Replaced(
      text, "<socket_child_frame>shank_offset</socket_child_frame>", "");
  text = Replaced(
      text,
      "<socket_parent>/bodyset/thigh</socket_parent>",
      "<connectors>" + connector("parent", "/leg/thigh") + "</connectors>");
  ExpectNear(ShankFrame(ReadText(text)), ShankFrame(ReadText(PinModel())));
}

TEST(ModelReader, PartsMayBeAmongTheComponentsOfTheModel) {
  std::string text = PinModelWithPoint(Point4("p2", "shank", "0 0 0"));
  const Model in_sets = ReadText(text);
  const auto move = [&](const std::string& element) {
    text = Replaced(text, element, "");
    text = Replaced(
        text, "</components></Model>", element + "</components></Model>");
  };
  text = Replaced(text, "</Model>", "<components></components></Model>");
  const auto between = [&](const std::string& from, const std::string& to) {
    const auto begin = text.find(from);
    return text.substr(begin, text.find(to) + to.size() - begin);
  };
  move("<Body name=\"shank\"/>");
  move(between("<PinJoint", "</PinJoint>"));
  move(between("<Thelen2003Muscle", "</Thelen2003Muscle>"));
  const Model model = ReadText(text);
  ASSERT_EQ(model.muscles.size(), 1u);
  EXPECT_EQ(model.muscles[0].path[1].body, kShank);
  ExpectNear(ShankFrame(model), ShankFrame(in_sets));
}

TEST(ModelReader, FramesThatNothingNeedsMayBeUnknown) {
  const std::string frame =
      "<PhysicalOffsetFrame name=\"f\"><socket_parent>nowhere</socket_parent>"
      "<attached_geometry><Mesh><mesh_file>a.stl</mesh_file></Mesh>"
      "</attached_geometry></PhysicalOffsetFrame>";
  const Model model = ReadText(Replaced(
      PinModel(),
      "<Body name=\"shank\"/>",
      "<Body name=\"shank\"><components>" + frame + "</components></Body>"));
  EXPECT_NO_THROW(CheckBodyIsSupported(model, kShank, "a test"));
  EXPECT_THAT(model.bodies[kShank].geometry, IsEmpty());
}

TEST(ModelReader, JointsOnUnknownFramesAreAnErrorWhereTheyAreNeeded) {
  const Model no_parent = ReadText(Replaced(PinModel(),
                                            "/bodyset/thigh</socket_parent>",
                                            "/bodyset/hip</socket_parent>"));
  ExpectInputError([&] { CheckBodyIsSupported(no_parent, kShank, "a test"); },
                   {"leg.osim", "\"shank\"", "/bodyset/hip", "line"});
  EXPECT_NO_THROW(CheckBodyIsSupported(no_parent, 1, "a test"));
  const Model no_child = ReadText(Replaced(PinModel(),
                                           "/bodyset/shank</socket_parent>",
                                           "/bodyset/foot</socket_parent>"));
  ASSERT_EQ(no_child.warnings.size(), 1u);
  EXPECT_THAT(no_child.warnings[0], HasSubstr("/bodyset/foot"));
  ExpectInputError([&] { CheckBodyIsSupported(no_child, kShank, "a test"); },
                   {"\"shank\" has no joint"});
}

TEST(ModelReader, CouplersAreReadWhereverTheyAre) {
  const std::string coupler =
      Coupler("a",
              "b",
              "<LinearFunction><coefficients>2 1</coefficients>"
              "</LinearFunction>");
  const std::string none = Model4(Joint4("UniversalJoint", "a b"));
  for (const std::string& text :
       {Replaced(none, "</Model>", coupler + "</Model>"),
        Replaced(none,
                 "<ConstraintSet name=\"constraintset\"><objects>",
                 "<ConstraintSet>" + coupler + "<objects>"),
        Replaced(none,
                 "</Model>",
                 "<components>" + coupler + "</components></Model>")}) {
    EXPECT_EQ(ReadText(text).couplers.size(), 1u);
  }
  // What new couplers begin with is no constraint.
  EXPECT_THAT(ReadText(Replaced(none,
                                "<Model ",
                                "<defaults>" + coupler + "</defaults><Model "))
                  .couplers,
              IsEmpty());
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
