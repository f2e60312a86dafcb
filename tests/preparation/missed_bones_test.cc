// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/missed_bones.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SceneBone Bone(const std::string& name, const std::string& body) {
  SceneBone bone;
  bone.name = name;
  bone.body = body;
  return bone;
}

std::vector<SceneBone> Leg() {
  return {Bone("femur", "femur_r"),
          Bone("tibia", "tibia_r"),
          Bone("fibula", "tibia_r"),
          Bone("talus", "talus_r"),
          Bone("calcaneus", "calcn_r"),
          Bone("metatarsal_1", "calcn_r")};
}

std::vector<std::string> Warnings(const std::string& muscle,
                                  const std::vector<LineEnd>& ends,
                                  const std::vector<SceneBone>& bones) {
  SceneMuscle named;
  named.name = muscle;
  return MissedBones(named, ends, bones);
}

TEST(MissedBones, NameTheBoneThatABellyDoesNotReach) {
  EXPECT_THAT(
      Warnings("soleus_right", {{"tibia_r", 1}, {"tibia_r", 9}}, Leg()),
      ElementsAre(AllOf(HasSubstr("soleus_right by its name ends on the "
                                  "calcaneus, which moves with calcn_r"),
                        HasSubstr("its lines end on tibia_r: is its tendon"))));
  EXPECT_THAT(Warnings("tib_ant_r", {{"tibia_r", 1}}, Leg()),
              ElementsAre(HasSubstr("tib_ant_r by its name ends on the ")));
}

TEST(MissedBones, AreNoneWhereTheLinesEndOnThem) {
  EXPECT_THAT(Warnings("soleus", {{"tibia_r", 1}, {"calcn_r", 1}}, Leg()),
              IsEmpty());
  EXPECT_THAT(
      Warnings("gastrocnemius_medial", {{"femur_r", 1}, {"calcn_r", 1}}, Leg()),
      IsEmpty());
}

TEST(MissedBones, AreNotGuessed) {
  const std::vector<LineEnd> belly = {{"tibia_r", 1}};
  EXPECT_THAT(Warnings("muscle_04", belly, Leg()), IsEmpty());
  // The scene has no foot.
  EXPECT_THAT(Warnings("soleus",
                       belly,
                       {Bone("tibia", "tibia_r"), Bone("femur", "femur_r")}),
              IsEmpty());
  // One body has both ends.
  EXPECT_THAT(
      Warnings(
          "soleus", belly, {Bone("tibia", "leg"), Bone("calcaneus", "leg")}),
      IsEmpty());
  // Lines of the scene.
  EXPECT_THAT(Warnings("soleus", {}, Leg()), IsEmpty());
  SceneMuscle named;
  named.name = "soleus";
  named.end_bodies = {"tibia_r", "calcn_r"};
  EXPECT_THAT(MissedBones(named, belly, Leg()), IsEmpty());
}

TEST(MissedBones, AreOfTheSideOfTheMuscle) {
  const std::vector<SceneBone> both = {Bone("tibia_left", "tibia_l"),
                                       Bone("tibia_right", "tibia_r"),
                                       Bone("calcaneus_left", "calcn_l"),
                                       Bone("calcaneus_right", "calcn_r")};
  EXPECT_THAT(Warnings("soleus_left", {{"tibia_l", 1}, {"calcn_l", 1}}, both),
              IsEmpty());
  EXPECT_THAT(Warnings("soleus_left", {{"tibia_l", 1}, {"calcn_r", 1}}, both),
              ElementsAre(HasSubstr("which moves with calcn_l, but")));
}

}  // namespace
}  // namespace musclewarp
