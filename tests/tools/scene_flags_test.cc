// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/scene_flags.h"

#include <gflags/gflags.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/angles.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The options of a run with some flags set; afterwards they are as before.
DeformOptions WithFlags(
    const std::vector<std::pair<std::string, std::string>>& flags) {
  const gflags::FlagSaver saver;
  gflags::SetCommandLineOption("scene", "scene.json");
  for (const auto& [name, value] : flags) {
    EXPECT_NE(gflags::SetCommandLineOption(name.c_str(), value.c_str()), "")
        << name;
  }
  DeformOptions options = SceneOptionsFromFlags();
  SetIterationLimit(&options.deformer.solver);
  return options;
}

void ExpectFlagRefused(const std::string& flag,
                       const std::string& value,
                       const std::string& allowed) {
  ExpectInputError(
      [&] {
        CheckSceneOptions(WithFlags({{flag, value}}));
      },
      {"--" + flag, value, "allowed: " + allowed});
}

TEST(SceneFlags, DefaultsAreThoseOfTheOptions) {
  const DeformOptions options = WithFlags({});
  CheckSceneOptions(options);
  const DeformOptions defaults;
  EXPECT_EQ(options.deformer.prepare.muscle.hull.coarse_vertices,
            defaults.deformer.prepare.muscle.hull.coarse_vertices);
  EXPECT_EQ(options.deformer.prepare.muscle.laplacian.weights,
            defaults.deformer.prepare.muscle.laplacian.weights);
  EXPECT_EQ(options.deformer.prepare.muscle.sample_spacing,
            defaults.deformer.prepare.muscle.sample_spacing);
  EXPECT_EQ(options.deformer.prepare.muscle.skeleton_weight,
            defaults.deformer.prepare.muscle.skeleton_weight);
  EXPECT_EQ(options.deformer.prepare.muscle.attachment_weight,
            defaults.deformer.prepare.muscle.attachment_weight);
  EXPECT_EQ(options.deformer.prepare.repair.holes.max_perimeter,
            defaults.deformer.prepare.repair.holes.max_perimeter);
  EXPECT_EQ(options.deformer.prepare.auto_lines,
            defaults.deformer.prepare.auto_lines);
  EXPECT_EQ(options.deformer.frames.paper.bone_hull.coarse_vertices,
            PaperSceneOptions().bone_hull.coarse_vertices);
  const CertifiedContactOptions& certified = options.deformer.frames.certified;
  const CertifiedContactOptions unset;
  EXPECT_EQ(certified.step.gap, unset.step.gap);
  EXPECT_EQ(certified.separation.cell.margin, unset.separation.cell.margin);
  EXPECT_EQ(certified.step.max_rounds, unset.step.max_rounds);
  EXPECT_EQ(certified.limits.max_turn, unset.limits.max_turn);
  EXPECT_EQ(certified.limits.max_move, unset.limits.max_move);
  EXPECT_EQ(certified.frame_timeout_s, unset.frame_timeout_s);
  EXPECT_EQ(options.frames, defaults.frames);
}

TEST(SceneFlags, EveryFlagReachesItsOption) {
  const DeformOptions options = WithFlags({{"coarse_vertices", "300"},
                                           {"bone_coarse_vertices", "400"},
                                           {"laplacian", "area"},
                                           {"laplacian_length", "3.5"},
                                           {"sample_spacing", "5"},
                                           {"skeleton_weight", "2"},
                                           {"attachment_weight", "3"},
                                           {"auto_lines", "4"},
                                           {"max_hole", "50"},
                                           {"motion", "walk.mot"},
                                           {"motion_in_degrees", "no"},
                                           {"geometry", "/,."},
                                           {"max_iterations", "60"},
                                           {"seed", "7"},
                                           {"threads", "8"},
                                           {"contact_level", "fine"},
                                           {"remake", "never"},
                                           {"attachments", "scene"},
                                           {"gap", "0.2"},
                                           {"max_rounds", "9"},
                                           {"max_step_turn", "1"},
                                           {"max_step_move", "5"},
                                           {"frame_timeout_s", "30"},
                                           {"body_twist", "false"}});
  EXPECT_EQ(options.deformer.prepare.muscle.hull.coarse_vertices, 300);
  EXPECT_EQ(options.deformer.frames.paper.bone_hull.coarse_vertices, 400);
  EXPECT_EQ(options.deformer.prepare.muscle.laplacian.weights,
            LaplacianWeights::kArea);
  EXPECT_EQ(options.deformer.prepare.muscle.laplacian.length_scale, 3.5);
  EXPECT_EQ(options.deformer.prepare.muscle.sample_spacing, 5);
  EXPECT_EQ(options.deformer.prepare.muscle.skeleton_weight, 2);
  EXPECT_EQ(options.deformer.prepare.muscle.attachment_weight, 3);
  EXPECT_EQ(options.deformer.prepare.attachments, AttachmentKind::kScene);
  EXPECT_EQ(options.deformer.prepare.auto_lines, 4);
  EXPECT_EQ(options.deformer.prepare.repair.holes.max_perimeter, 50);
  EXPECT_EQ(options.model.motion, "walk.mot");
  EXPECT_EQ(options.model.motion_in_degrees, false);
  EXPECT_EQ(options.model.geometry, (std::vector<std::string>{"/", "."}));
  EXPECT_EQ(options.deformer.solver.gauss_newton.max_iterations, 60);
  EXPECT_EQ(options.deformer.frames.paper.group.paper.seed, 7u);
  EXPECT_EQ(options.threads, 8);
  EXPECT_EQ(options.deformer.frames.paper.group.level, ContactLevel::kFine);
  EXPECT_EQ(options.deformer.reconstruction.kind, ReconstructionKind::kNever);
  EXPECT_FALSE(options.deformer.frames.pre_rotation.use_body_twist);
  const CertifiedContactOptions& certified = options.deformer.frames.certified;
  EXPECT_EQ(certified.step.gap, 0.2);
  EXPECT_EQ(certified.separation.cell.margin, 0.4);
  EXPECT_EQ(certified.step.max_rounds, 9);
  EXPECT_EQ(certified.limits.max_turn, RadiansOf(1));
  EXPECT_EQ(certified.limits.max_move, 5);
  EXPECT_EQ(certified.frame_timeout_s, 30);
}

TEST(SceneFlags, RefusesValuesThatAreNotAllowedByTheNameOfTheFlag) {
  for (const char* value : {"-1", "nan"}) {
    ExpectFlagRefused("max_hole", value, "0 or above");
    ExpectFlagRefused("laplacian_length", value, "0 or above");
    ExpectFlagRefused("attachment_weight", value, "0 to 1e6");
    ExpectFlagRefused("skeleton_weight", value, "above 0, at most 1e6");
    ExpectFlagRefused("sample_spacing", value, "0.01 mm or above");
  }
  for (const char* value : {"19", "-5", "5001"}) {
    ExpectFlagRefused("coarse_vertices", value, "20 to 5000");
    ExpectFlagRefused("bone_coarse_vertices", value, "20 to 5000");
  }
  ExpectFlagRefused("skeleton_weight", "0", "above 0");
  ExpectFlagRefused("skeleton_weight", "inf", "above 0, at most 1e6");
  ExpectFlagRefused("attachment_weight", "inf", "0 to 1e6");
  ExpectFlagRefused("sample_spacing", "0.001", "0.01 mm or above");
  ExpectFlagRefused("auto_lines", "0", "1 or above");
  ExpectFlagRefused("max_iterations", "0", "1 or above");
  ExpectFlagRefused("threads", "-1", "0 (all cores) to 1024");
  ExpectFlagRefused("threads", "1000000", "0 (all cores) to 1024");
  ExpectFlagRefused("contact_level", "middle", "coarse, fine");
  ExpectFlagRefused("remake", "always", "auto, never");
  ExpectFlagRefused("attachments", "all", "auto, scene, none");
  ExpectFlagRefused("laplacian", "none", "area, paper");
  ExpectInputError(
      [] {
        WithFlags({{"laplacian", "paper"}, {"laplacian_length", "3"}});
      },
      {"--laplacian_length", "add --laplacian=area"});
  for (const char* value : {"0", "-1", "nan", "0.6"}) {
    ExpectFlagRefused("gap", value, "above 0");
  }
  ExpectFlagRefused("max_rounds", "0", "1 or above");
  ExpectFlagRefused("max_step_turn", "0", "above 0");
  ExpectFlagRefused("max_step_move", "0", "above 0");
  ExpectFlagRefused("frame_timeout_s", "-2", "0 or above, or -1");
}

TEST(SceneFlags, NoMessageNamesAStructOfTheLibrary) {
  for (const char* flag : {"max_hole",
                           "coarse_vertices",
                           "bone_coarse_vertices",
                           "sample_spacing",
                           "skeleton_weight",
                           "attachment_weight",
                           "auto_lines",
                           "max_iterations",
                           "threads"}) {
    try {
      CheckSceneOptions(WithFlags({{flag, "-1"}}));
      ADD_FAILURE() << flag << " was not refused";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr(std::string("--") + flag + ": is -1; "),
                        Not(HasSubstr("::"))));
    }
  }
}

TEST(SceneFlags, TheRecordedCommandHasTheFlagsThatWereSet) {
  const DeformOptions options =
      WithFlags({{"frames", "0:2"}, {"threads", "3"}, {"data_root", "a b"}});
  // The report has them lead from the folder of the run (PathsInJson).
  const std::string here = std::filesystem::current_path().string();
  EXPECT_THAT(options.command,
              AllOf(HasSubstr(" --frames=0:2"),
                    HasSubstr(" --threads=3"),
                    HasSubstr(" --data_root='" + here + "/a b'"),
                    HasSubstr(" --scene=" + here + "/scene.json"),
                    Not(HasSubstr("max_hole"))));
  // Neither the number of threads nor the place of files changes a result.
  EXPECT_EQ(options.result_flags, " --frames=0:2");
  EXPECT_EQ(options.all_flags.at("max_hole"), "30");
}

}  // namespace
}  // namespace musclewarp
