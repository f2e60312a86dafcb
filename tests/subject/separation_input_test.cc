// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/separate_input.h"

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

SeparateOptions OutTo(const std::string& dir) {
  SeparateOptions options;
  options.out = dir + "/out";
  return options;
}

void ExpectInputRefused(const std::vector<std::string>& files,
                        const SeparateOptions& options,
                        const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadSeparateInput(files, options); }, words);
}

}  // namespace

TEST(SeparateInput, MeshFilesAreReadLater) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(1, 2, 3));
  WriteTriangleSoup(dir + "/b.obj", Box(1, 2, 3));
  SeparateOptions options = OutTo(dir);
  options.bones = {dir + "/b.obj"};
  const SeparateInput input = ReadSeparateInput({dir + "/a.ply"}, options);
  ASSERT_EQ(input.scene.muscles.size(), 1u);
  EXPECT_EQ(input.scene.muscles[0].mesh_path, dir + "/a.ply");
  EXPECT_EQ(input.scene.muscles[0].points.rows(), 0);
  EXPECT_TRUE(input.scene.muscles[0].lines.empty());
  EXPECT_EQ(input.scene.bones[0].name, "b");
  EXPECT_TRUE(input.image.empty());
}

TEST(SeparateInput, FilesOfAnotherSpaceAreTurned) {
  const std::string dir = TestTempDir();
  const std::string body =
      "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  WriteTextAtomically(dir + "/a.obj", "# SPACE=LPS\n" + body);
  WriteTextAtomically(dir + "/b.obj", "# SPACE=RAS\n" + body);
  SeparateOptions options = OutTo(dir);
  options.bones = {dir + "/b.obj"};
  const SeparateInput input = ReadSeparateInput({dir + "/a.obj"}, options);
  EXPECT_FALSE(input.scene.muscles[0].is_turned);
  EXPECT_TRUE(input.scene.bones[0].is_turned);
  ASSERT_EQ(input.scene.warnings.size(), 1u);
  EXPECT_NE(input.scene.warnings[0].find("b.obj states the space RAS"),
            std::string::npos);
}

#ifdef MUSCLEWARP_WITH_VTK
// The surfaces of labels are in LPS.
TEST(SeparateInput, FilesAreBroughtIntoTheSpaceOfTheImage) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTextAtomically(dir + "/b.obj",
                      "# SPACE=RAS\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
                      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  SeparateOptions options = OutTo(dir);
  options.bones = {dir + "/b.obj"};
  const SeparateInput input = ReadSeparateInput({image}, options);
  EXPECT_EQ(input.labels.frame, "LPS");
  EXPECT_TRUE(input.scene.bones[0].is_turned);
}

TEST(SeparateInput, LabelsAreBonesByTheTableOrByTheirNames) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTextAtomically(dir + "/table.csv", "1,psoas\n2,femur\n3,hip,bone\n");
  WriteTriangleSoup(dir + "/nail.ply", Box(1, 2, 3));
  SeparateOptions options = OutTo(dir);
  options.labels = dir + "/table.csv";
  options.bones = {"femur", dir + "/nail.ply"};
  const SeparateInput input = ReadSeparateInput({image}, options);
  EXPECT_EQ(input.image, image);
  ASSERT_EQ(input.scene.muscles.size(), 1u);
  EXPECT_EQ(input.scene.muscles[0].name, "psoas");
  EXPECT_GT(input.scene.muscles[0].triangles.rows(), 0);
  ASSERT_EQ(input.scene.bones.size(), 3u);
  EXPECT_EQ(input.scene.bones[0].name, "femur");
  EXPECT_EQ(input.scene.bones[1].name, "hip");
  EXPECT_EQ(input.scene.bones[2].name, "nail");
  EXPECT_TRUE(input.labels.meshes[1].is_bone);
}

TEST(SeparateInput, MeshFilesMayComeWithAnImage) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTriangleSoup(dir + "/tendon.ply", Box(1, 2, 3));
  const SeparateInput input =
      ReadSeparateInput({dir + "/tendon.ply", image}, OutTo(dir));
  ASSERT_EQ(input.scene.muscles.size(), 4u);
  EXPECT_EQ(input.scene.muscles[0].name, "label_1");
  EXPECT_EQ(input.scene.muscles[3].name, "tendon");
}

TEST(SeparateInput, RefusesNamesThatDoNotFitTheImage) {
  const std::string dir = TestTempDir(), image = dir + "/a.nrrd";
  WriteBars(image);
  WriteTriangleSoup(dir + "/label_2.ply", Box(1, 2, 3));
  SeparateOptions options = OutTo(dir);
  options.bones = {"femur"};
  ExpectInputRefused({image},
                     options,
                     {"--bone: has \"femur\", which is neither a label of",
                      "the labels are label_1, label_2, label_3"});
  options.bones = {"label_1", "label_2", "label_3"};
  ExpectInputRefused({image}, options, {"a.nrrd: has bones only"});
  ExpectInputRefused({dir + "/label_2.ply", image},
                     OutTo(dir),
                     {"has the name \"label_2\"", "label_2.ply"});
  ExpectInputRefused({image, dir + "/b.nii"},
                     OutTo(dir),
                     {"b.nii: is a second label image beside"});
  options.bones = {dir + "/b.nii"};
  ExpectInputRefused({image}, options, {"b.nii: is a label image"});
}
#else
TEST(SeparateInput, LabelImagesNeedVtk) {
  const std::string dir = TestTempDir();
  WriteBars(dir + "/a.nrrd");
  ExpectInputRefused(
      {dir + "/a.nrrd"},
      OutTo(dir),
      {"a.nrrd: label images need VTK", "-DMUSCLEWARP_WITH_VTK=ON"});
}
#endif

TEST(SeparateInput, OptionsForLabelsNeedAnImage) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(1, 2, 3));
  SeparateOptions options = OutTo(dir);
  options.labels = "table.csv";
  ExpectInputRefused({dir + "/a.ply"},
                     options,
                     {"--labels=table.csv: names labels", ".nii.gz"});
  options.labels.clear();
  options.edge = 2;
  ExpectInputRefused({dir + "/a.ply"}, options, {"--edge: is for", "leave"});
}

}  // namespace musclewarp
