// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/scene_settings.h"
#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// The flags of this process, which gflags keeps to its end.
struct TestFlags {
  SceneSettings scene;
  ThreadSettings threads;
  DeformerSettings deformer;

  TestFlags() {
    RegisterFlags(&scene);
    RegisterFlags(&threads);
    RegisterFlags(&deformer, {"solver"});
  }
};

class Flags : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { flags_ = new TestFlags; }

  static void Set(const std::string& name, const std::string& value) {
    EXPECT_NE(gflags::SetCommandLineOption(name.c_str(), value.c_str()), "")
        << name;
  }

  static TestFlags* flags_;

 private:
  const gflags::FlagSaver saver_;
};
TestFlags* Flags::flags_ = nullptr;

TEST_F(Flags, AreStoredInTheSettings) {
  Set("gap", "0.25");
  Set("auto_lines", "5");
  Set("seed", "7");
  Set("body_twist", "false");
  Set("contact", "none");
  EXPECT_EQ(flags_->deformer.gap, 0.25);
  EXPECT_EQ(flags_->deformer.auto_lines, 5);
  EXPECT_EQ(flags_->deformer.seed, 7U);
  EXPECT_FALSE(flags_->deformer.body_twist);
  EXPECT_EQ(flags_->deformer.contact, "none");
  EXPECT_THAT(
      GivenFlags(),
      ElementsAre("auto_lines", "body_twist", "contact", "gap", "seed"));
}

TEST_F(Flags, HaveTheDefaultsOfTheSettings) {
  const DeformerSettings defaults;
  EXPECT_EQ(flags_->deformer.gap, defaults.gap);
  EXPECT_EQ(flags_->deformer.contact, defaults.contact);
  EXPECT_TRUE(GivenFlags().empty());
}

TEST_F(Flags, AreThoseThatAProgramHas) {
  gflags::CommandLineFlagInfo info;
  EXPECT_FALSE(gflags::GetCommandLineFlagInfo("solver", &info));
  EXPECT_TRUE(gflags::GetCommandLineFlagInfo("gap", &info));
}

// The list of all flags would else be one block of forty.
TEST_F(Flags, HaveTheHeadingOfTheStructThatListsThem) {
  std::map<std::string, std::string> headings;
  for (const ProgramFlag& flag : ProgramFlags()) {
    headings[flag.name] = flag.heading;
  }
  EXPECT_EQ(headings.at("contact"), HeadingOf(Described<DeformerSettings>()));
  EXPECT_EQ(headings.at("gap"), HeadingOf(Described<RestSettings>()));
  EXPECT_EQ(headings.at("scene"), HeadingOf(Described<SceneSettings>()));
}

TEST_F(Flags, AreRecordedWithPathsThatLeadFromAnywhere) {
  Set("scene", "scene.json");
  Set("data_root", "a b, c");
  Set("frames", "0:2");
  Set("threads", "3");
  const std::string here = std::filesystem::current_path().string();
  const std::string command = CommandLine({"threads"});
  EXPECT_THAT(command, HasSubstr(" --frames=0:2"));
  EXPECT_THAT(command, HasSubstr(" --data_root='" + here + "/a b, c'"));
  EXPECT_THAT(command, HasSubstr(" --scene=" + here + "/scene.json"));
  EXPECT_THAT(command, Not(HasSubstr("threads")));
  EXPECT_THAT(command, Not(HasSubstr("max_hole")));
  EXPECT_EQ(AllFlagValues().at("max_hole"), "30");
  EXPECT_EQ(AllFlagValues().at("cache"), "none");
}

// Neither the number of threads nor the place of files changes a result.
TEST_F(Flags, ThatChangeResultsAreTold) {
  Set("scene", "scene.json");
  Set("threads", "3");
  Set("cache", "/tmp/cache");
  Set("frames", "0:2");
  Set("gap", "0.25");
  EXPECT_EQ(ResultFlagsText(), " --frames=0:2 --gap=0.25");
}

TEST_F(Flags, GoToAFileForFlags) {
  Set("gap", "0.25");
  Set("frames", "0:2");
  Set("threads", "2");
  EXPECT_EQ(FlagFileOf(flags_->deformer, {}), "--gap=0.25\n");
  EXPECT_EQ(FlagFileOf(flags_->scene, {"frames"}), "");
}

}  // namespace
}  // namespace musclewarp
