// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
// From a label image to meshes that do not cross, by the program.
#ifdef MUSCLEWARP_WITH_VTK
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/program/program.h"
#include "support/made_images.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

// Of the volume of the voxels.
constexpr double kVolumeOfVoxels = 1e-3;

// Voxels of 1 x 1 x 1.5 mm in a turned frame: a bone (3) along the third axis,
// within two muscles (1 and 2) that touch it and each other.
MadeImage MusclesAroundABone() {
  const Eigen::Matrix4d lps_from_index =
      TurnedSteps({1, 1, 1.5}, {-120, 80, 950});
  const Eigen::Matrix4d index_from_lps = lps_from_index.inverse();
  return MakeImage(
      {30, 30, 28}, lps_from_index, [&](const Eigen::Vector3d& place) {
        const Eigen::Vector3d at =
            (index_from_lps * place.homogeneous()).head<3>();
        const double x = at[0] - 14.5, y = at[1] - 14.5, z = at[2] - 13.5;
        if (std::hypot(x, y + 8) < 4) return 3;
        const bool is_muscle =
            std::hypot(std::hypot(x, y), z * 14 / 12.0) < 13.5;
        return !is_muscle ? 0 : x < 0 ? 1 : 2;
      });
}

double FileVolume(const std::string& file) {
  const TriangleSoup soup = ReadTriangleSoup(file);
  return SignedVolume(soup.points, soup.triangles);
}

}  // namespace

// A label in two halves loses one of them, whether it moves or not.
TEST(SeparateLabels, ALabelThatLosesAHalfIsNotUsable) {
  const std::string dir = TestTempDir();
  const MadeImage image = MakeImage({40, 20, 20},
                                    TurnedSteps({1, 1, 1}, {0, 0, 0}),
                                    [](const Eigen::Vector3d&) { return 0; });
  MadeImage made = image;
  int at = 0;
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 40; ++i, ++at) {
        const bool is_half = i % 20 > 3 && i % 20 < 16;
        if (is_half && j > 3 && j < 9 && k > 3 && k < 16) made.labels[at] = 1;
        if (is_half && j > 11 && j < 16 && k > 3 && k < 16) made.labels[at] = 2;
      }
    }
  }
  WriteTextAtomically(dir + "/halves.mha", MetaImageBytes(made));
  const std::string command =
      dir + "/halves.mha --bone=label_2 --out=" + dir + "/out";
  const ProgramRun run = RunCommandLine(MUSCLEWARP_SEPARATE, command);
  EXPECT_EQ(run.exit_code, 1) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("not usable: label_1: 50 % of its volume"));
  EXPECT_THAT(run.out, HasSubstr("not usable: label_2: 50"));
  const ProgramRun all =
      RunCommandLine(MUSCLEWARP_SEPARATE,
                     dir + "/halves.mha --pieces=all --out=" + dir + "/all");
  EXPECT_EQ(all.exit_code, 0) << all.out << all.errors;
  EXPECT_EQ(RunCommandLine(MUSCLEWARP_SEPARATE, command + " --max_loss=0.6")
                .exit_code,
            0);
}

TEST(SeparateLabels, TouchingLabelsComeOutApartWithTheirVolumes) {
  const std::string dir = TestTempDir(), out = dir + "/out";
  const MadeImage image = MusclesAroundABone();
  WriteTextAtomically(dir + "/thigh.mha", MetaImageBytes(image));
  WriteTextAtomically(dir + "/labels.csv",
                      "label,name,kind\n1,vastus,muscle\n2,biceps,muscle\n"
                      "3,femur,bone\n4,tibia,bone\n");
  const ProgramRun run = RunCommandLine(MUSCLEWARP_SEPARATE,
                                        "--out=" + out + " --labels=" + dir +
                                            "/labels.csv --json --threads=1 " +
                                            dir + "/thigh.mha");
  ASSERT_EQ(run.exit_code, kExitUsable) << run.out << run.errors;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("3 labels became meshes, in mm, frame LPS"),
                    HasSubstr("label 4 (tibia)"),
                    HasSubstr(" before, 0 after\n")));

  const std::string files =
      out + "/vastus.ply " + out + "/biceps.ply " + out + "/femur.ply";
  const ProgramRun check =
      RunCommandLine(MUSCLEWARP_CHECK, files + " --gap=0.1 --require_clean");
  EXPECT_EQ(check.exit_code, kExitUsable) << check.out;
  EXPECT_NEAR(FileVolume(out + "/vastus.ply") / VoxelVolumeOf(image, 1),
              1,
              kVolumeOfVoxels);
  EXPECT_NEAR(FileVolume(out + "/biceps.ply") / VoxelVolumeOf(image, 2),
              1,
              kVolumeOfVoxels);

  const Json json = Json::parse(FileText(out + "/separation.json"));
  EXPECT_GE(json["smallest_gap_mm"], 0.1);
  EXPECT_EQ(json["muscles"].size(), 2u);
  EXPECT_EQ(json["bones"].size(), 1u);
  EXPECT_EQ(json["bones"][0]["name"], "femur");
  EXPECT_EQ(json["label_image"]["frame"], "LPS");
  EXPECT_EQ(json["label_image"]["notes"].size(), 1u);
  const Json& labels = json["label_image"]["labels"];
  ASSERT_EQ(labels.size(), 3u);
  EXPECT_EQ(labels[2]["bone"], true);
  EXPECT_NEAR(labels[2]["voxel_volume_mm3"], VoxelVolumeOf(image, 3), 1e-6);
}

TEST(SeparateLabels, BadImagesLeaveNothingBehind) {
  const std::string dir = TestTempDir(), out = dir + "/out";
  const std::string bytes = MetaImageBytes(MusclesAroundABone());
  WriteTextAtomically(dir + "/torn.mha", bytes.substr(0, bytes.size() - 100));
  WriteTextAtomically(dir + "/whole.mha", bytes);
  WriteTextAtomically(dir + "/labels.csv", "1,vastus,tendon\n");
  const auto refused = [&](const std::string& arguments,
                           const std::string& words) {
    const ProgramRun run =
        RunCommandLine(MUSCLEWARP_SEPARATE, "--out=" + out + " " + arguments);
    EXPECT_EQ(run.exit_code, kExitBadInput);
    EXPECT_THAT(run.errors, HasSubstr(words));
    EXPECT_FALSE(fs::exists(out));
  };
  refused(dir + "/torn.mha", "torn.mha: is truncated");
  refused(dir + "/none.nii.gz", "none.nii.gz: does not exist");
  refused(dir + "/whole.mha --labels=none.csv",
          "--labels=none.csv: does not exist");
  refused("--labels=" + dir + "/labels.csv " + dir + "/whole.mha",
          "labels.csv: line 1: has the kind 'tendon'");
  refused("--bone=tibia " + dir + "/whole.mha",
          "--bone: has \"tibia\", which is neither a label");
  refused("--edge=-1 " + dir + "/whole.mha", "--edge: is -1");
}

}  // namespace musclewarp
#endif
