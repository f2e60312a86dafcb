// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/deformer_settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/settings/checked_settings.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

TEST(DeformerSettings, AreByDefaultTheOptions) {
  const DeformerOptions chosen = OptionsOf(DeformerSettings()), options;
  EXPECT_EQ(chosen.frames.contact, options.frames.contact);
  EXPECT_EQ(chosen.frames.certified.step.gap,
            options.frames.certified.step.gap);
  EXPECT_EQ(chosen.frames.certified.limits.max_turn,
            options.frames.certified.limits.max_turn);
  EXPECT_EQ(chosen.frames.paper.group.level, options.frames.paper.group.level);
  EXPECT_EQ(chosen.solver.name, options.solver.name);
  EXPECT_EQ(chosen.solver.gauss_newton.max_iterations,
            options.solver.gauss_newton.max_iterations);
  EXPECT_EQ(chosen.prepare.attachments, options.prepare.attachments);
  EXPECT_EQ(chosen.prepare.muscle.line_rule, options.prepare.muscle.line_rule);
  EXPECT_EQ(chosen.prepare.muscle.laplacian.weights,
            options.prepare.muscle.laplacian.weights);
  EXPECT_EQ(chosen.prepare.muscle.attachment_weight,
            options.prepare.muscle.attachment_weight);
  EXPECT_EQ(chosen.reconstruction.kind, options.reconstruction.kind);
  EXPECT_TRUE(chosen.lengths_in_mm.empty());
  EXPECT_TRUE(chosen.cache.folder.empty());
}

TEST(DeformerSettings, ReachTheOptionsOfThePreparation) {
  DeformerSettings settings;
  settings.coarse_vertices = 300;
  settings.bone_coarse_vertices = 400;
  settings.laplacian_length = 3.5;
  settings.lines = "slide";
  settings.sample_spacing = 5;
  settings.skeleton_weight = 2;
  settings.attachment_weight = 3;
  settings.bending_weight = 4;
  settings.attachments = "scene";
  settings.auto_lines = 4;
  settings.fibres = 9;
  settings.max_hole = 50;
  settings.cache = "folder";
  const DeformerOptions options = OptionsOf(settings);
  const MuscleModelOptions& muscle = options.prepare.muscle;
  EXPECT_EQ(muscle.hull.coarse_vertices, 300);
  EXPECT_EQ(options.frames.paper.bone_hull.coarse_vertices, 400);
  EXPECT_EQ(muscle.laplacian.length_scale, 3.5);
  EXPECT_EQ(muscle.line_rule, LineRule::kSlide);
  EXPECT_EQ(muscle.sample_spacing, 5);
  EXPECT_EQ(muscle.skeleton_weight, 2);
  EXPECT_EQ(muscle.attachment_weight, 3);
  EXPECT_EQ(muscle.bending_weight, 4);
  EXPECT_EQ(options.prepare.attachments, AttachmentKind::kScene);
  EXPECT_EQ(options.prepare.auto_lines, 4);
  EXPECT_EQ(options.prepare.fibres.fibres, 9);
  EXPECT_EQ(options.prepare.repair.holes.max_perimeter, 50);
  EXPECT_EQ(options.cache.folder, "folder");
}

TEST(DeformerSettings, ReachTheOptionsOfFrames) {
  DeformerSettings settings;
  settings.max_iterations = 60;
  settings.seed = 7;
  settings.contact = "paper";
  settings.contact_level = "fine";
  settings.remake = "never";
  settings.body_twist = false;
  settings.bone_push = false;
  settings.gap = 0.25;
  settings.max_rounds = 9;
  settings.max_step_turn = 90;
  settings.max_step_move = 5;
  settings.frame_timeout_s = 30;
  settings.max_loss = 0.1;
  settings.max_lost_area = 11;
  settings.max_lost_extent = 12;
  settings.max_torn_patch = 13;
  const DeformerOptions options = OptionsOf(settings);
  EXPECT_EQ(options.solver.gauss_newton.max_iterations, 60);
  EXPECT_EQ(options.solver.ceres.iteration.max_iterations, 60);
  EXPECT_EQ(options.frames.paper.group.paper.seed, 7U);
  EXPECT_EQ(options.frames.contact, ContactKind::kPaper);
  EXPECT_EQ(options.frames.paper.group.level, ContactLevel::kFine);
  EXPECT_EQ(options.reconstruction.kind, ReconstructionKind::kNever);
  EXPECT_FALSE(options.frames.pre_rotation.use_body_twist);
  EXPECT_FALSE(options.bone_push.enabled);
  const CertifiedContactOptions& certified = options.frames.certified;
  EXPECT_EQ(certified.step.gap, 0.25);
  EXPECT_EQ(certified.step.max_rounds, 9);
  EXPECT_EQ(certified.limits.max_turn, M_PI / 2);
  EXPECT_EQ(certified.limits.max_move, 5);
  EXPECT_EQ(certified.frame_timeout_s, 30);
  EXPECT_EQ(options.frames.requirements.max_volume_loss, 0.1);
  EXPECT_EQ(options.frames.requirements.max_lost_area, 11);
  EXPECT_EQ(options.frames.requirements.max_lost_extent, 12);
  EXPECT_EQ(options.frames.requirements.max_torn_patch, 13);
  EXPECT_EQ(options.lengths_in_mm.count("gap"), 1U);
}

// The rule holds for options that no setting made, too.
TEST(DeformerSettings, MeshesAreSeparatedByTwiceTheGap) {
  CertifiedContactOptions options;
  options.step.gap = 0.25;
  EXPECT_EQ(options.SeparationByGap().cell.margin, 0.5);
}

TEST(DeformerSettings, RefuseWhatDoesNotFit) {
  DeformerSettings settings;
  settings.laplacian = "paper";
  settings.laplacian_length = 3;
  ExpectInputError([&] { OptionsOf(settings); },
                   {"--laplacian_length", "add --laplacian=area"});
}

TEST(DeformerSettings, HaveAKeyOfWhatChangesResults) {
  DeformerSettings settings;
  const std::string key = KeyOf(settings);
  settings.cache = "elsewhere";
  EXPECT_EQ(KeyOf(settings), key);
  settings.gap = std::nextafter(settings.gap, 1);
  EXPECT_NE(KeyOf(settings), key);
  settings = {};
  settings.given = {"gap"};  // in mm, whatever the size of the body
  EXPECT_NE(KeyOf(settings), key);
}

}  // namespace
}  // namespace musclewarp
