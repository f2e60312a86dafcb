// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/articulate_input.h"

#ifdef MUSCLEWARP_WITH_VTK
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Voxels of 1 mm: label 1 in two blocks, and label 2, 3 and 4 in one each.
MadeImage BlocksOfLabels() {
  return MakeImage(
      {70, 20, 20},
      TurnedSteps({1, 1, 1}, {0, 0, 0}),
      [](const Eigen::Vector3d& place) {
        const Eigen::Vector3d at =
            (TurnedSteps({1, 1, 1}, {0, 0, 0}).inverse() * place.homogeneous())
                .head<3>();
        const int block = static_cast<int>(at[0] + 0.5) / 14;
        const double x = at[0] - 14 * block;
        const bool is_inside = x > 2 && x < 11 && at[1] > 4 && at[1] < 15 &&
                               at[2] > 4 && at[2] < 15;
        if (!is_inside) return 0;
        return block < 2 ? 1 : block;
      });
}

ArticulateInput ReadLabels(const std::string& table) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/labels.mha", MetaImageBytes(BlocksOfLabels()));
  ArticulateOptions options;
  options.labels = dir + "/labels.csv";
  WriteTextAtomically(options.labels, table);
  return ReadArticulateInput({dir + "/labels.mha"}, options);
}

std::vector<std::string> NamesOf(const std::vector<Bone>& bones) {
  std::vector<std::string> names;
  for (const Bone& bone : bones) names.push_back(bone.name);
  return names;
}

TEST(ReadArticulateInput, MeshesOfTwoSpacesAreRefused) {
  const std::string dir = TestTempDir();
  const std::string mesh = "\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n";
  WriteTextAtomically(dir + "/femur_left.obj", "# SPACE=LPS" + mesh);
  WriteTextAtomically(dir + "/tibia_left.obj", "# SPACE=RAS" + mesh);
  ExpectInputError(
      [&] {
        ReadArticulateInput({dir + "/femur_left.obj", dir + "/tibia_left.obj"},
                            {});
      },
      {"tibia_left.obj", "states the space RAS", "femur_left.obj LPS"});
}

TEST(ReadArticulateInput, TakesApartWhatThereIsOnBothSides) {
  const ArticulateInput input =
      ReadLabels("label,name\n1,tibia\n2,femur_left\n3,soleus\n4,sacrum\n");
  EXPECT_THAT(NamesOf(input.bones),
              ElementsAre("tibia_1", "tibia_2", "femur_left", "sacrum"));
  EXPECT_EQ(input.bones[0].kind, BoneKind::kTibia);
  EXPECT_FALSE(input.bones[0].side);
  EXPECT_EQ(input.bones[2].side, Side::kLeft);
  ASSERT_EQ(input.muscles.size(), 1u);
  EXPECT_EQ(input.muscles[0].name, "soleus");
  EXPECT_TRUE(input.is_oriented);
}

TEST(ReadArticulateInput, KeepsBothHalvesOfAPelvis) {
  const ArticulateInput input = ReadLabels("label,name\n1,pelvis\n");
  EXPECT_THAT(NamesOf(input.bones), ElementsAre("pelvis_1", "pelvis_2"));
}

TEST(ReadArticulateInput, TakesWhatTheTableSaysOfBonesAndMuscles) {
  const ArticulateInput input = ReadLabels(
      "label,name,kind,bone,side,body,origin,insertion\n"
      "2,thigh,bone,femur,right,,,\n"
      "3,stem,bone,,,femur_r,,\n"
      "4,calf,muscle,,,,femur_r,calcn_r\n");
  EXPECT_THAT(NamesOf(input.bones), ElementsAre("thigh", "stem"));
  EXPECT_EQ(input.bones[0].kind, BoneKind::kFemur);
  EXPECT_EQ(input.bones[0].side, Side::kRight);
  EXPECT_EQ(input.bones[1].kind, BoneKind::kOther);
  EXPECT_EQ(input.bones[1].body, "femur_r");
  EXPECT_EQ(input.muscles[0].origin, "femur_r");
  EXPECT_EQ(input.muscles[0].insertion, "calcn_r");
}

TEST(ReadArticulateInput, RefusesColumnsThatItDoesNotKnow) {
  ExpectInputError(
      [] { ReadLabels("label,name,kind,bone\n2,thigh,bone,femr\n"); },
      {"\"thigh\"", "column bone", "\"femr\"", "femur"});
  ExpectInputError(
      [] { ReadLabels("label,name,kind,side\n2,femur,bone,up\n"); },
      {"\"femur\"", "column side", "\"up\"", "right, left"});
}

}  // namespace
}  // namespace musclewarp
#endif
