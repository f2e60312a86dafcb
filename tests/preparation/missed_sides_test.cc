// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/missed_sides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Names of bones and their bodies.
using Bones = std::vector<std::pair<std::string, std::string>>;

const Bones kLeg = {{"femur", "femur_r"},
                    {"tibia", "tibia_r"},
                    {"fibula", "tibia_r"},
                    {"talus", "talus_r"},
                    {"calcaneus", "calcn_r"},
                    {"metatarsal_1", "calcn_r"}};

// Bones 100 mm apart along x, of which each is a box.
Surroundings SurroundingsOf(const Bones& bones) {
  Surroundings surroundings;
  double x = 0;
  for (const auto& [name, body] : bones) {
    surroundings.AddBone(name, body, MovedBy(Box(10, 30, 10), {x, 0, 0}));
    x += 100;
  }
  return surroundings;
}

// A line between two bodies.
ActionLine LineBetween(const std::string& from, const std::string& to) {
  ActionLine line;
  line.rest = Points::Zero(2, 3);
  line.rest(1, 1) = 100;
  line.bodies = {from, to};
  return line;
}

std::vector<std::string> MissedBy(const std::string& muscle,
                                  const ActionLine& line,
                                  const Bones& bones) {
  SceneMuscle named;
  named.name = muscle;
  return MissedBones(named, {line}, SurroundingsOf(bones));
}

TEST(MissedBones, NameTheBoneThatABellyDoesNotReach) {
  const ActionLine belly = LineBetween("tibia_r", "tibia_r");
  EXPECT_THAT(
      MissedBy("soleus_right", belly, kLeg),
      ElementsAre(AllOf(HasSubstr("soleus_right by its name ends on the "
                                  "calcaneus, which moves with calcn_r"),
                        HasSubstr("its lines end on tibia_r: is its tendon"))));
  EXPECT_THAT(MissedBy("tib_ant_r", belly, kLeg),
              ElementsAre(HasSubstr("tib_ant_r by its name ends on the ")));
  EXPECT_THAT(MissedBy("gastrocnemius", belly, kLeg), SizeIs(2));
}

TEST(MissedBones, AreNoneWhereTheLinesEndOnThem) {
  EXPECT_THAT(MissedBy("soleus", LineBetween("tibia_r", "calcn_r"), kLeg),
              IsEmpty());
  EXPECT_THAT(
      MissedBy("gastrocnemius_medial", LineBetween("calcn_r", "femur_r"), kLeg),
      IsEmpty());
}

TEST(MissedBones, AreNotGuessed) {
  const ActionLine belly = LineBetween("tibia_r", "tibia_r");
  EXPECT_THAT(MissedBy("muscle_04", belly, kLeg), IsEmpty());
  // The scene has no foot.
  EXPECT_THAT(
      MissedBy("soleus", belly, {{"tibia", "tibia_r"}, {"femur", "femur_r"}}),
      IsEmpty());
  // One body has both ends.
  EXPECT_THAT(
      MissedBy("soleus", belly, {{"tibia", "leg"}, {"calcaneus", "leg"}}),
      IsEmpty());
  // Its bodies are not known.
  ActionLine of_points = belly;
  of_points.bodies.clear();
  EXPECT_THAT(MissedBy("soleus", of_points, kLeg), IsEmpty());
}

TEST(MissedBones, AreOfTheSideOfTheMuscle) {
  const Bones both = {{"tibia_left", "tibia_l"},
                      {"tibia_right", "tibia_r"},
                      {"calcaneus_left", "calcn_l"},
                      {"calcaneus_right", "calcn_r"}};
  EXPECT_THAT(MissedBy("soleus_left", LineBetween("tibia_l", "calcn_l"), both),
              IsEmpty());
  EXPECT_THAT(MissedBy("soleus_left", LineBetween("tibia_l", "calcn_r"), both),
              ElementsAre(HasSubstr("which moves with calcn_l, but")));
}

TEST(MissedSides, AreThoseOfNamedBodiesThatAreFar) {
  const Surroundings surroundings = SurroundingsOf(kLeg);
  SceneMuscle muscle;
  muscle.name = "muscle_04";
  muscle.end_bodies = {"tibia_r", "femur_r"};
  ActionLine line = LineBetween("tibia_r", "femur_r");
  // From the tibia to 100 mm away from the femur.
  line.rest.row(0) << 100, 10, 0;
  line.rest.row(1) << 0, 115, 0;
  const auto missed = MissedSides(muscle, {line}, surroundings);
  ASSERT_EQ(missed.size(), 1u);
  EXPECT_FALSE(missed[0].is_origin);
  EXPECT_EQ(missed[0].body, "femur_r");
  EXPECT_THAT(missed[0].landmarks, IsEmpty());
  EXPECT_THAT(MissedBones(muscle, {line}, surroundings), IsEmpty());
  line.rest.row(1) << 0, 25, 0;  // 10 mm away
  EXPECT_THAT(MissedSides(muscle, {line}, surroundings), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
