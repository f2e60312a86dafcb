// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/measured_arms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

MeasuredArms ArmsOfText(const std::string& text) {
  const std::string path = TestTempDir() + "/arms.csv";
  WriteTextAtomically(path, text);
  return ReadMeasuredArms(path);
}

MeasuredArm ArmOf(const std::string& joint,
                  const std::string& coordinate,
                  const std::string& muscle) {
  MeasuredArm arm;
  arm.joint = joint;
  arm.coordinate = coordinate;
  arm.muscle = muscle;
  return arm;
}

TEST(MeasuredArms, ReadsWhatTheTableHas) {
  const MeasuredArms measured = ArmsOfText(
      "joint,coordinate,muscle,angle_deg,moment_arm_mm,sd_mm,source,method\n"
      "hip,flexion,psoas,30,24.5,1.5,\"Arnold, 2000\",excursion\n"
      "hip,flexion,psoas,,30,,Someone,\n"
      "hip,flexion,psoas,10,,,Ratios,\n");
  ASSERT_EQ(measured.arms.size(), 2u);
  EXPECT_EQ(measured.rows_without_arm, 1);
  EXPECT_EQ(measured.arms[0].angle_deg, 30);
  EXPECT_EQ(measured.arms[0].arm_mm, 24.5);
  EXPECT_EQ(measured.arms[0].sd_mm, 1.5);
  EXPECT_EQ(measured.arms[0].source, "Arnold, 2000");
  EXPECT_EQ(measured.arms[0].detail, "excursion");
  EXPECT_EQ(measured.arms[1].angle_deg, std::nullopt);
}

TEST(MeasuredArms, RefusesOtherTables) {
  ExpectInputError([] { ArmsOfText("muscle,bound\na,upper\n"); },
                   {"arms.csv", "has no column coordinate, moment_arm_mm"});
  ExpectInputError(
      [] { ArmsOfText("coordinate,muscle,moment_arm_mm\nflexion,a,x\n"); },
      {"line 2", "moment_arm_mm 'x'"});
}

TEST(MeasuredArms, FindsMusclesByTheirWords) {
  const ArmsOfRun run = {{{"hip_flexion_r", -10}},
                         {"psoas_major_r",
                          "gastrocnemius_medial_r",
                          "calcaneal_tendon_r",
                          "fibularis_longus_r",
                          "Gluteus Maximus"}};
  const auto muscles = [&](const std::string& measured) {
    const auto place = PlaceOf(ArmOf("hip", "flexion", measured), run);
    return place ? place->muscles : std::vector<std::string>();
  };
  EXPECT_THAT(muscles("psoas"), ElementsAre("psoas_major_r"));
  EXPECT_THAT(muscles("gastrocnemius_medialis"),
              ElementsAre("gastrocnemius_medial_r"));
  // The arm of a tendon is that of the muscles that pull on it.
  EXPECT_THAT(muscles("achilles_tendon"),
              ElementsAre("gastrocnemius_medial_r"));
  EXPECT_THAT(muscles("peroneus_longus"), ElementsAre("fibularis_longus_r"));
  EXPECT_THAT(muscles("gluteus_maximus"), ElementsAre("Gluteus Maximus"));
  EXPECT_THAT(muscles("gluteus_medius"), ElementsAre());
  EXPECT_THAT(muscles("psoas_minor"), ElementsAre());
  EXPECT_THAT(muscles("r"), ElementsAre());
  const auto alone = PlaceOf(ArmOf("hip", "flexion", "achilles_tendon"),
                             {{{"hip_flexion_r", 0}}, {"calcaneal_tendon"}});
  EXPECT_THAT(alone->muscles, ElementsAre("calcaneal_tendon"));
}

TEST(MeasuredArms, FindsCoordinatesAndTheirSense) {
  const auto place = [](const std::string& joint,
                        const std::string& coordinate,
                        const std::string& of_run,
                        double lowest = 0) {
    return PlaceOf(ArmOf(joint, coordinate, "m"), {{{of_run, lowest}}, {"m"}});
  };
  EXPECT_FALSE(place("hip", "flexion", "hip_flexion_r").value().turned);
  EXPECT_FALSE(place("hip", "flexion", "hip_flexion").value().turned);
  EXPECT_FALSE(
      place("hip", "internal_rotation", "hip_rotation_l").value().turned);
  EXPECT_FALSE(place("knee", "flexion", "knee_angle_r").value().turned);
  EXPECT_TRUE(place("knee", "flexion", "knee_angle_r", -60).value().turned);
  EXPECT_TRUE(place("ankle", "plantarflexion", "ankle_angle_r").value().turned);
  EXPECT_TRUE(place("shoulder", "abduction", "arm_add_r").value().turned);
  EXPECT_FALSE(place("hip", "flexion", "knee_angle_r"));
  EXPECT_FALSE(place("shoulder", "flexion", "hip_flexion_r"));
}

TEST(MeasuredArms, TheNoteCountsWhatIsLeftOut) {
  MeasuredArms measured;
  measured.arms = {ArmOf("hip", "flexion", "psoas"),
                   ArmOf("hip", "flexion", "soleus"),
                   ArmOf("knee", "flexion", "psoas")};
  measured.rows_without_arm = 4;
  const std::string note =
      MeasuredNote(measured, {{{"hip_flexion_r", 0}}, {"psoas_r"}});
  EXPECT_THAT(note, HasSubstr("1 of 3 measured moment arms"));
  EXPECT_THAT(note, HasSubstr("2 are of muscles or coordinates"));
  EXPECT_THAT(note, HasSubstr("4 rows have no moment arm"));
}

}  // namespace
}  // namespace musclewarp
