// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/bones_file.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(BonesFile, GivesBackWhatItWasGivenToTheLastBit) {
  const std::string file = TestTempDir() + "/bones.json";
  const Eigen::Affine3d motion =
      Eigen::Translation3d(-800.0 / 3, 1e-17, 2) *
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized());
  const BoneMotions bones = {{"femur \"r\"", motion.matrix()},
                             {"pelvis", Eigen::Matrix4d::Identity()}};
  WriteBonesFile(file, bones);
  EXPECT_EQ(ReadBonesFile(file), bones);
}

TEST(BonesFile, MayBeWithoutBones) {
  const std::string file = TestTempDir() + "/bones.json";
  WriteBonesFile(file, {});
  EXPECT_TRUE(ReadBonesFile(file).empty());
}

TEST(BonesFile, DamageIsNamed) {
  const std::string file = TestTempDir() + "/bones.json";
  const auto refused = [&](const std::string& text, const std::string& words) {
    WriteTextAtomically(file, text);
    ExpectInputError([&] { ReadBonesFile(file); }, {file, words});
  };
  refused("{", "JSON");
  refused("{}", "bones");
  refused(R"({"bones": {"femur": [[1, 0, 0, 0]]}})", "femur");
  refused(R"({"bones": {"femur": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0],
                                  [0, 0, 0, 1]]}})",
          "rigid");
}

}  // namespace
}  // namespace musclewarp
