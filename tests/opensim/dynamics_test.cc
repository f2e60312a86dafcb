// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/dynamics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

const char kThigh[] = R"(<Body name="thigh"/>)";

Model WithThigh(const std::string& properties, const std::string& forces = "") {
  return ReadModel(
      Written("leg.osim",
              Replaced(Model4(Joint4("PinJoint", "knee"), "", forces),
                       kThigh,
                       "<Body name=\"thigh\">" + properties + "</Body>")));
}

TEST(Dynamics, HasMassesOfBothVersions) {
  const std::string common =
      "<mass>8</mass><mass_center>0 -0.17 0.01</mass_center>";
  const std::string of_4 = "<inertia>0.1 0.02 0.13 1e-3 2e-3 3e-3</inertia>";
  const std::string of_3 =
      "<inertia_xx>0.1</inertia_xx><inertia_yy>0.02</inertia_yy>"
      "<inertia_zz>0.13</inertia_zz><inertia_xy>1e-3</inertia_xy>"
      "<inertia_xz>2e-3</inertia_xz><inertia_yz>3e-3</inertia_yz>";
  for (const std::string& inertia : {of_4, of_3}) {
    const auto bodies = DynamicsOf(WithThigh(common + inertia)).bodies;
    const BodyMass& thigh = bodies.at("thigh");
    EXPECT_EQ(thigh.mass, 8);
    EXPECT_EQ(thigh.centre, Eigen::Vector3d(0, -170, 10));
    EXPECT_THAT(thigh.inertia, ElementsAre(0.1, 0.02, 0.13, 1e-3, 2e-3, 3e-3));
    EXPECT_EQ(bodies.at("shank").mass, 0);
  }
}

TEST(Dynamics, HasTheForcesOfMuscles) {
  const std::string muscle =
      Replaced(Muscle("vastus",
                      Point4("a", "/bodyset/thigh", "0 0 0") +
                          Point4("b", "/bodyset/shank", "0 0 0")),
               "<GeometryPath",
               "<max_isometric_force>1200</max_isometric_force>"
               "<tendon_slack_length>0.25</tendon_slack_length><GeometryPath");
  const auto muscles = DynamicsOf(WithThigh("", muscle)).muscles;
  ASSERT_EQ(muscles.size(), 1u);
  EXPECT_EQ(muscles.at("vastus").force, 1200);
  EXPECT_EQ(muscles.at("vastus").tendon, 250);
}

TEST(Dynamics, RefusesWhatIsNoNumber) {
  const Model model = WithThigh("<mass>heavy</mass>");
  ExpectInputError([&] { DynamicsOf(model); }, {"leg.osim", "mass"});
}

}  // namespace
}  // namespace musclewarp
