// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deformer_settings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

// Expects that the choices are refused, once changed, with the words.
void ExpectChoicesRefused(const std::function<void(DeformerSettings*)>& change,
                          const std::vector<std::string>& words) {
  DeformerSettings choices;
  change(&choices);
  ExpectInputError([&] { OptionsOf(choices); }, words);
}

TEST(DeformerSettings, AreByDefaultTheOptions) {
  const DeformerOptions chosen = OptionsOf({}), options;
  EXPECT_EQ(chosen.frames.contact, options.frames.contact);
  EXPECT_EQ(chosen.frames.certified.step.gap,
            options.frames.certified.step.gap);
  EXPECT_EQ(chosen.solver.name, options.solver.name);
  EXPECT_EQ(chosen.prepare.attachments, options.prepare.attachments);
  EXPECT_EQ(chosen.prepare.fibres.fibres, options.prepare.fibres.fibres);
  EXPECT_EQ(chosen.prepare.muscle.attachment_weight,
            options.prepare.muscle.attachment_weight);
  EXPECT_EQ(chosen.reconstruction.kind, options.reconstruction.kind);
}

TEST(DeformerSettings, TurnIntoTheUnitsOfTheLibrary) {
  DeformerSettings choices;
  choices.max_step_turn = 90;
  choices.contact = "paper";
  choices.gap = 0.25;
  const DeformerOptions options = OptionsOf(choices);
  EXPECT_EQ(options.frames.certified.limits.max_turn, M_PI / 2);
  EXPECT_EQ(options.frames.contact, ContactKind::kPaper);
  EXPECT_EQ(options.frames.certified.separation.cell.margin, 0.5);
}

TEST(DeformerSettings, NameTheFlagOfWhatIsNotAllowed) {
  ExpectChoicesRefused([](DeformerSettings* c) { c->contact = "rubber"; },
                       {"--contact=rubber", "certified, paper, none"});
  ExpectChoicesRefused([](DeformerSettings* c) { c->gap = 1; }, {"--gap"});
  ExpectChoicesRefused([](DeformerSettings* c) { c->max_step_turn = 0; },
                       {"--max_step_turn", "above 0"});
  ExpectChoicesRefused([](DeformerSettings* c) { c->max_iterations = 0; },
                       {"--max_iterations", "1 or above"});
}

}  // namespace
}  // namespace musclewarp
