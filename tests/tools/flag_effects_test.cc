// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The flags of musclewarp-deform beside the settings of the deformer
// (settings_effects_test.cc): those whose mark says that they change no result
// leave every file of the frames as it is.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "support/temp_dir.h"
#include "tools/deform_command.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> FramesOf(const std::string& flags,
                                            const std::string& out) {
  const ProgramRun run = RunCommandLine(
      MUSCLEWARP_DEFORM,
      "--scene=" MUSCLEWARP_DATA_DIR "/phantom/motion.json --frames=1 --out=" +
          out + " " + flags);
  EXPECT_EQ(run.exit_code, 0) << flags << run.out << run.errors;
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string file = fs::relative(entry.path(), out).string();
    if (entry.is_regular_file() && file.rfind("frame_", 0) == 0) {
      texts[file] = FileText(entry.path().string());
    }
  }
  return texts;
}

// Adds the marks of a list, but for flags without which there is no run.
template <class Settings>
void AddEffects(std::map<std::string, Effect>* effects) {
  VisitFields(Settings(), [&](const auto& field, const auto& /*value*/) {
    (*effects)[field.key] = field.effect;
  });
}

TEST(FlagEffects, AreAsTheListsSay) {
  const std::string dir = TestTempDir();
  const auto as_is = FramesOf("", dir + "/as_is");
  ASSERT_FALSE(as_is.empty());
  fs::copy_file(MUSCLEWARP_DATA_DIR "/phantom/hip.mot", dir + "/other.mot");
  const std::map<std::string, std::string> values = {
      {"scene", ""},  // there is one already
      {"out", ""},
      {"data_root", MUSCLEWARP_DATA_DIR "/phantom"},
      {"frames", "2"},
      {"motion", dir + "/other.mot"},
      {"motion_in_degrees", "yes"},
      {"geometry", dir},
      {"html", "true"},
      {"resume", "true"},
      {"overwrite", "true"},
      {"profile", "true"},
      {"record_steps", dir + "/steps"},
      {"threads", "1"}};
  std::map<std::string, Effect> effects;
  AddEffects<SceneSettings>(&effects);
  AddEffects<RunSettings>(&effects);
  AddEffects<ThreadSettings>(&effects);
  for (const auto& [flag, effect] : effects) {
    ASSERT_EQ(values.count(flag), 1U) << flag << ": say here how to give it";
    if (values.at(flag).empty()) continue;
    const auto frames =
        FramesOf("--" + flag + "=" + values.at(flag), dir + "/" + flag);
    if (effect == Effect::kFiles) {
      EXPECT_NE(frames, as_is) << flag;
    } else if (effect == Effect::kNothing) {
      EXPECT_EQ(frames, as_is) << flag;
    }
  }
}

}  // namespace
}  // namespace musclewarp
