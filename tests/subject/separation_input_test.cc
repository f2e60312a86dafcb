// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/subject/subject.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// Three bars that touch each other, of labels 1 to 3.
void WriteBars(const std::string& path) {
  WriteTextAtomically(
      path,
      NrrdBytes(MakeImage({24, 10, 12},
                          Eigen::Matrix4d::Identity(),
                          [](const Eigen::Vector3d& place) {
                            return 1 + static_cast<int>(place[0]) / 8;
                          })));
}

SubjectInput InputOf(const std::vector<std::string>& files,
                     const std::vector<std::string>& bones = {}) {
  SubjectInput input;
  input.files = files;
  input.bones = bones;
  return input;
}

void ExpectInputRefused(const SubjectInput& input,
                        const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadSubject(input); }, words);
}

}  // namespace

TEST(SeparationInput, MeshFilesAreReadLater) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(1, 2, 3));
  WriteTriangleSoup(dir + "/b.obj", Box(1, 2, 3));
  const Subject subject =
      ReadSubject(InputOf({dir + "/a.ply"}, {dir + "/b.obj"}));
  const Scene scene = SceneOfSubject(subject, 1);
  ASSERT_EQ(scene.muscles.size(), 1u);
  EXPECT_EQ(scene.muscles[0].mesh_path, dir + "/a.ply");
  EXPECT_EQ(scene.muscles[0].points.rows(), 0);
  EXPECT_TRUE(scene.muscles[0].lines.empty());
  EXPECT_EQ(scene.bones[0].name, "b");
  EXPECT_TRUE(subject.image.empty());
}

TEST(SeparationInput, FilesOfAnotherSpaceAreTurned) {
  const std::string dir = TestTempDir();
  const std::string body =
      "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  WriteTextAtomically(dir + "/a.obj", "# SPACE=LPS\n" + body);
  WriteTextAtomically(dir + "/b.obj", "# SPACE=RAS\n" + body);
  const Scene scene = SceneOfSubject(
      ReadSubject(InputOf({dir + "/a.obj"}, {dir + "/b.obj"})), 1);
  EXPECT_FALSE(scene.muscles[0].is_turned);
  EXPECT_TRUE(scene.bones[0].is_turned);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("b.obj states the space RAS"),
            std::string::npos);
}

#ifdef MUSCLEWARP_WITH_VTK
// The surfaces of labels are in LPS.
TEST(SeparationInput, FilesAreBroughtIntoTheSpaceOfTheImage) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTextAtomically(dir + "/b.obj",
                      "# SPACE=RAS\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
                      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const Subject subject = ReadSubject(InputOf({image}, {dir + "/b.obj"}));
  EXPECT_EQ(subject.labels.frame, "LPS");
  EXPECT_TRUE(subject.bones[0].is_turned);
}

TEST(SeparationInput, LabelsAreBonesByTheTableOrByTheirNames) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTextAtomically(dir + "/table.csv", "1,psoas\n2,femur\n3,hip,bone\n");
  WriteTriangleSoup(dir + "/nail.ply", Box(1, 2, 3));
  SubjectInput input = InputOf({image}, {"femur", dir + "/nail.ply"});
  input.labels.table = dir + "/table.csv";
  const Subject subject = ReadSubject(input);
  EXPECT_EQ(subject.image, image);
  const Scene scene = SceneOfSubject(subject, 1);
  ASSERT_EQ(scene.muscles.size(), 1u);
  EXPECT_EQ(scene.muscles[0].name, "psoas");
  EXPECT_GT(scene.muscles[0].triangles.rows(), 0);
  EXPECT_EQ(scene.muscles[0].delivered_volume,
            subject.labels.meshes[0].delivered_volume);
  ASSERT_EQ(scene.bones.size(), 3u);
  EXPECT_EQ(scene.bones[0].name, "femur");
  EXPECT_EQ(scene.bones[1].name, "hip");
  EXPECT_EQ(scene.bones[2].name, "nail");
  EXPECT_TRUE(subject.labels.meshes[1].is_bone);
  // What labels of bones have lost, since no frame says it.
  ASSERT_EQ(subject.lost.size(), 2u);
  EXPECT_EQ(subject.lost[0].name, "femur");
}

TEST(SeparationInput, MeshFilesMayComeWithAnImage) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTriangleSoup(dir + "/tendon.ply", Box(1, 2, 3));
  const Subject subject = ReadSubject(InputOf({dir + "/tendon.ply", image}));
  ASSERT_EQ(subject.muscles.size(), 4u);
  EXPECT_EQ(subject.muscles[0].name, "label_1");
  EXPECT_EQ(subject.muscles[3].name, "tendon");
}

TEST(SeparationInput, RefusesNamesThatDoNotFitTheImage) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTriangleSoup(dir + "/label_2.ply", Box(1, 2, 3));
  ExpectInputRefused(InputOf({image}, {"femur"}),
                     {"--bone: has \"femur\", which is neither a label of",
                      "the labels are label_1, label_2, label_3"});
  ExpectInputRefused(InputOf({image}, {"label_1", "label_2", "label_3"}),
                     {"a.nrrd: has bones only"});
  ExpectInputRefused(InputOf({dir + "/label_2.ply", image}),
                     {"has the name \"label_2\"", "label_2.ply"});
  ExpectInputRefused(InputOf({image, dir + "/b.nii"}),
                     {"b.nii: is a second label image beside"});
  ExpectInputRefused(InputOf({image}, {dir + "/b.nii"}),
                     {"b.nii: is a label image"});
}
#else
TEST(SeparationInput, LabelImagesNeedVtk) {
  const std::string dir = TestTempDir();
  WriteBars(dir + "/a.nrrd");
  ExpectInputRefused(
      InputOf({dir + "/a.nrrd"}),
      {"a.nrrd: label images need VTK", "-DMUSCLEWARP_WITH_VTK=ON"});
}
#endif

TEST(SeparationInput, OptionsForLabelsNeedAnImage) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(1, 2, 3));
  SubjectInput input = InputOf({dir + "/a.ply"});
  input.labels.table = "table.csv";
  ExpectInputRefused(input, {"--labels=table.csv: names labels", ".nii.gz"});
  input.labels.table.clear();
  input.labels.edge_length = 2;
  ExpectInputRefused(input, {"--edge: is for", "leave"});
}

}  // namespace musclewarp
