// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/attachments_file.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(RecordedAttachments, AreReadAsTheyWereWritten) {
  RecordedAttachments written;
  written.muscles["psoas_r"] = {{"femur_r", {4, 5}}, {"pelvis", {0, 2, 7}}};
  written.muscles["loose"] = {};
  written.bones = {{"femur", "femur_r"}, {"ilium", "pelvis"}};
  const std::string path = TestTempDir() + "/attachments.json";
  WriteAttachments(path, written);
  const RecordedAttachments read = ReadAttachments(path);
  EXPECT_EQ(read.bones, written.bones);
  ASSERT_EQ(read.muscles.at("psoas_r").size(), 2u);
  EXPECT_EQ(read.muscles.at("psoas_r")[1].body, "pelvis");
  EXPECT_EQ(read.muscles.at("psoas_r")[1].vertices,
            (std::vector<int>{0, 2, 7}));
}

TEST(RecordedAttachments, AreOfTheMusclesOfAScene) {
  PreparedScene scene;
  scene.muscles.resize(1);
  PreparedMuscle& muscle = scene.muscles[0];
  muscle.model.name = "psoas_r";
  muscle.model.attachments.resize(3);
  muscle.model.attachments[0].body = "pelvis";
  muscle.model.attachments[1].body = "femur_r";
  muscle.model.attachments[2].body = "pelvis";
  muscle.attached.vertices = {1, 3, 4, 8};
  muscle.attached.attachment = {2, 0, 1, 0};
  scene.bones.resize(1);
  scene.bones[0].mesh.name = "femur";
  scene.bones[0].body = "femur_r";
  const RecordedAttachments recorded = AttachmentsOf(scene);
  const std::vector<AttachedArea>& areas = recorded.muscles.at("psoas_r");
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_EQ(areas[0].body, "femur_r");
  EXPECT_EQ(areas[0].vertices, std::vector<int>{4});
  EXPECT_EQ(areas[1].vertices, (std::vector<int>{1, 3, 8}));
  EXPECT_EQ(recorded.bones.at("femur"), "femur_r");
}

TEST(RecordedAttachments, DamageIsNamed) {
  const std::string path = TestTempDir() + "/attachments.json";
  const auto refused = [&](const std::string& text, const std::string& field) {
    WriteTextAtomically(path, text);
    ExpectInputError([&] { ReadAttachments(path); }, {path, field});
  };
  refused("{}", "muscles");
  refused(R"({"muscles": {}})", "bones");
  refused(R"({"muscles": {"a": [{"vertices": []}]}, "bones": {}})", "body");
  refused(R"({"muscles": {"a": [{"body": "b", "vertices": [1.5]}]},
              "bones": {}})",
          "muscles.a[0].vertices[0]");
}

}  // namespace
}  // namespace musclewarp
