// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/subject/subject.h"

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

Subject ReadLabels(const std::string& table,
                   const std::vector<std::string>& bones = {}) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/labels.mha", MetaImageBytes(BlocksOfLabels()));
  SubjectInput input;
  input.use = SubjectUse::kJoints;
  input.files = {dir + "/labels.mha"};
  input.bones = bones;
  input.labels.table = dir + "/labels.csv";
  WriteTextAtomically(input.labels.table, table);
  return ReadSubject(input);
}

std::vector<std::string> NamesOf(const std::vector<SubjectMesh>& meshes) {
  std::vector<std::string> names;
  for (const SubjectMesh& mesh : meshes) names.push_back(mesh.name);
  return names;
}

TEST(JointsInput, MeshesOfTwoSpacesAreRefused) {
  const std::string dir = TestTempDir();
  const std::string mesh = "\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n";
  WriteTextAtomically(dir + "/femur_left.obj", "# SPACE=LPS" + mesh);
  WriteTextAtomically(dir + "/tibia_left.obj", "# SPACE=RAS" + mesh);
  SubjectInput input;
  input.use = SubjectUse::kJoints;
  input.files = {dir + "/femur_left.obj", dir + "/tibia_left.obj"};
  ExpectInputError(
      [&] { ReadSubject(input); },
      {"tibia_left.obj", "states the space RAS", "femur_left.obj LPS"});
}

TEST(JointsInput, TakesApartWhatThereIsOnBothSides) {
  const Subject input =
      ReadLabels("label,name\n1,tibia\n2,femur_left\n3,soleus\n4,sacrum\n");
  EXPECT_THAT(NamesOf(input.bones),
              ElementsAre("tibia_1", "tibia_2", "femur_left", "sacrum"));
  EXPECT_EQ(input.bones[0].bone.kind, BoneKind::kTibia);
  EXPECT_FALSE(input.bones[0].bone.side);
  EXPECT_EQ(input.bones[2].bone.side, Side::kLeft);
  ASSERT_EQ(input.muscles.size(), 1u);
  EXPECT_EQ(input.muscles[0].name, "soleus");
  EXPECT_TRUE(input.IsOriented());
}

TEST(JointsInput, KeepsBothHalvesOfAPelvis) {
  const Subject input = ReadLabels("label,name\n1,pelvis\n");
  EXPECT_THAT(NamesOf(input.bones), ElementsAre("pelvis_1", "pelvis_2"));
}

TEST(JointsInput, TakesWhatTheTableSaysOfBonesAndMuscles) {
  const Subject input = ReadLabels(
      "label,name,kind,bone,side,body,origin,insertion\n"
      "2,thigh,bone,femur,right,,,\n"
      "3,stem,bone,,,femur_r,,\n"
      "4,calf,muscle,,,,femur_r,calcn_r\n");
  EXPECT_THAT(NamesOf(input.bones), ElementsAre("thigh", "stem"));
  EXPECT_EQ(input.bones[0].bone.kind, BoneKind::kFemur);
  EXPECT_EQ(input.bones[0].bone.side, Side::kRight);
  EXPECT_EQ(input.bones[1].bone.kind, BoneKind::kOther);
  EXPECT_EQ(input.bones[1].body, "femur_r");
  EXPECT_EQ(input.muscles[0].origin, "femur_r");
  EXPECT_EQ(input.muscles[0].insertion, "calcn_r");
}

TEST(JointsInput, RefusesColumnsThatItDoesNotKnow) {
  ExpectInputError(
      [] { ReadLabels("label,name,kind,bone\n2,thigh,bone,femr\n"); },
      {"\"thigh\"", "column bone", "\"femr\"", "femur"});
  ExpectInputError(
      [] { ReadLabels("label,name,kind,side\n2,femur,bone,up\n"); },
      {"\"femur\"", "column side", "\"up\"", "right, left"});
}

TEST(JointsInput, RefusesNamesThatAreNoLabels) {
  ExpectInputError([] { ReadLabels("label,name\n2,femur\n", {"nail"}); },
                   {"--bone: has \"nail\", which is no label", "femur"});
  const Subject input = ReadLabels("label,name\n2,nail\n", {"nail"});
  EXPECT_THAT(NamesOf(input.bones), ElementsAre("nail"));
}

TEST(JointsInput, IsThatOfAnImageInMemory) {
  const Subject read = ReadLabels("label,name\n1,tibia\n2,femur_left\n");
  SubjectInput input;
  input.use = SubjectUse::kJoints;
  LabelEntry tibia, femur;
  tibia.label = 1;
  tibia.name = "tibia";
  femur.label = 2;
  femur.name = "femur_left";
  input.labels.table = "rows";
  input.labels.rows = {tibia, femur};
  const Subject made =
      ReadSubject(input, ReadLabelImage(TestTempPath() + "/labels.mha"));
  ASSERT_EQ(NamesOf(made.bones), NamesOf(read.bones));
  for (size_t i = 0; i < made.bones.size(); ++i) {
    EXPECT_EQ(made.bones[i].mesh.points, read.bones[i].mesh.points);
    EXPECT_GT(made.bones[i].delivered_volume, 0);
  }
}

}  // namespace
}  // namespace musclewarp
#endif
