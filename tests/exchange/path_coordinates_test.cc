// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_coordinates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A pelvis that moves on the ground, a thigh and a shank; "rectus" is a muscle
// of the model from the pelvis to the shank.
Model Leg() {
  const auto body = [](const std::string& name,
                       const std::string& parent,
                       const std::string& coordinate) {
    return "<Body name=\"" + name + "\"><Joint><PinJoint name=\"j_" + name +
           "\"><parent_body>" + parent +
           "</parent_body><CoordinateSet><objects><Coordinate name=\"" +
           coordinate +
           "\"/></objects></CoordinateSet></PinJoint></Joint></Body>";
  };
  const auto point = [](const std::string& name, const std::string& of) {
    return "<PathPoint name=\"" + name + "\"><location>0 0 0</location><body>" +
           of + "</body></PathPoint>";
  };
  const std::string file = TestTempDir() + "/leg.osim";
  WriteTextAtomically(
      file,
      "<OpenSimDocument Version=\"30000\"><Model name=\"leg\"><BodySet>"
      "<objects><Body name=\"ground\"/>" +
          body("pelvis", "ground", "tilt") + body("thigh", "pelvis", "hip") +
          body("shank", "thigh", "knee") +
          "</objects></BodySet><ForceSet><objects><Thelen2003Muscle "
          "name=\"rectus\"><GeometryPath><PathPointSet><objects>" +
          point("a", "pelvis") + point("b", "thigh") + point("c", "shank") +
          "</objects></PathPointSet></GeometryPath></Thelen2003Muscle>"
          "</objects></ForceSet></Model></OpenSimDocument>");
  return ReadModel(file);
}

MuscleFigures MuscleOn(const std::string& name,
                       const std::vector<std::string>& carriers) {
  MuscleFigures muscle;
  muscle.name = name;
  for (const std::string& carrier : carriers) {
    muscle.attachments.emplace_back().body = carrier;
  }
  return muscle;
}

class PathCoordinates : public ::testing::Test {
 protected:
  std::vector<int> CrossedBy(const std::string& muscle,
                             const std::string& line) const {
    return CrossedCoordinates(
        model_, {0, 1, 2}, BodiesOfPath(model_, frame_, muscle, line));
  }

  const Model model_ = Leg();
  FrameFigures frame_;
};

TEST_F(PathCoordinates, OfAMuscleOfTheModelAreThoseBetweenItsPoints) {
  frame_.muscles = {MuscleOn("front", {"thigh"})};
  EXPECT_THAT(CrossedBy("front", "rectus"), ElementsAre(1, 2));
}

TEST_F(PathCoordinates, OfAnotherLineAreThoseBetweenTheAttachments) {
  frame_.muscles = {MuscleOn("vastus", {"thigh", "shank"}),
                    MuscleOn("iliacus", {"pelvis", "thigh"}),
                    MuscleOn("short", {"thigh", "thigh"})};
  EXPECT_THAT(CrossedBy("vastus", "line"), ElementsAre(2));
  EXPECT_THAT(CrossedBy("iliacus", "line"), ElementsAre(1));
  EXPECT_THAT(CrossedBy("short", "line"), IsEmpty());
}

TEST_F(PathCoordinates, GoOnThroughMusclesThatCarryOthers) {
  // The tendon carries the muscle and the other way round.
  frame_.muscles = {MuscleOn("gastrocnemius", {"thigh", "tendon"}),
                    MuscleOn("tendon", {"shank", "gastrocnemius"})};
  EXPECT_THAT(CrossedBy("gastrocnemius", "line"), ElementsAre(2));
}

TEST_F(PathCoordinates, TakeTheIndicesOfTheGivenList) {
  frame_.muscles = {MuscleOn("vastus", {"thigh", "shank"})};
  EXPECT_THAT(
      CrossedCoordinates(
          model_, {2, 0}, BodiesOfPath(model_, frame_, "vastus", "line")),
      ElementsAre(0));
}

}  // namespace
}  // namespace musclewarp
