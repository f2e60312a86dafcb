// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/kept_model.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

JsonField MotionField(const nlohmann::json& json) {
  return JsonField::Parse(json.dump(), "report.json");
}

TEST(KeptModel, IsACopyInTheRun) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/leg.osim", "<OpenSimDocument/>");
  fs::create_directories(dir + "/run/rest");
  Scene scene;
  KeepModel(scene, dir + "/run");
  EXPECT_TRUE(fs::is_empty(dir + "/run/rest"));
  const auto model = std::make_shared<ModelPoses>();
  model->model.path = dir + "/leg.osim";
  scene.model = model;
  KeepModel(scene, dir + "/run");
  fs::remove(dir + "/leg.osim");
  const JsonField motion =
      MotionField({{"model", "../leg.osim"}, {"kept_model", kKeptModel}});
  EXPECT_EQ(ReadFile(ModelOfRun(dir + "/run", motion)), "<OpenSimDocument/>");
}

TEST(KeptModel, OfEarlierBuildsIsTheOneThatWasRead) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/leg.osim", "");
  EXPECT_EQ(
      ModelOfRun(dir + "/run", MotionField({{"model", dir + "/leg.osim"}})),
      dir + "/leg.osim");
  // A path from the working folder.
  EXPECT_EQ(ModelOfRun(dir + "/run", MotionField({{"model", "data/leg.osim"}})),
            "data/leg.osim");
}

}  // namespace
}  // namespace musclewarp
