// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/step_options.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "support/invalid_options.h"

namespace musclewarp {
namespace {

struct WrongOption {
  std::string message;
  std::function<void(StepOptions*)> set;
};

void ExpectAllRefused(const std::vector<WrongOption>& wrong) {
  for (const WrongOption& option : wrong) {
    ExpectRefused<StepOptions>(option.set, option.message);
  }
}

TEST(StepOptions, NameTheFieldThatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectAllRefused(
      {{"StepOptions::gap is 0, allowed: above 0",
        [](StepOptions* o) { o->gap = 0; }},
       {"StepOptions::gap is nan, allowed: above 0",
        [nan](StepOptions* o) { o->gap = nan; }},
       {"StepOptions::reach is 0.05, allowed: above 0.1",
        [](StepOptions* o) { o->reach = 0.05; }},
       {"StepOptions::sweeps is 0, allowed: 1 or above",
        [](StepOptions* o) { o->sweeps = 0; }},
       {"StepOptions::repair_sweeps is -2, allowed: 1 or above",
        [](StepOptions* o) { o->repair_sweeps = -2; }},
       {"StepOptions::max_rounds is 0, allowed: 1 or above",
        [](StepOptions* o) { o->max_rounds = 0; }},
       {"StepOptions::max_polishing_rounds is -1, allowed: 0 or above",
        [](StepOptions* o) { o->max_polishing_rounds = -1; }},
       {"PlaneSearchOptions::sheet_distance is -1, allowed: 0 or above",
        [](StepOptions* o) { o->planes.sheet_distance = -1; }},
       {"PlaneSearchOptions::min_facing is 2, allowed: 0 to 1",
        [](StepOptions* o) { o->planes.min_facing = 2; }},
       {"PlaneSearchOptions::search_fraction is -1, allowed: 0 to 1",
        [](StepOptions* o) { o->planes.search_fraction = -1; }},
       {"PlaneSearchOptions::overlooked_fraction is 1.5, allowed: 0 to 0.9",
        [](StepOptions* o) { o->planes.overlooked_fraction = 1.5; }},
       {"PlaneSearchOptions::kept_slack is -1, allowed: 0 or above",
        [](StepOptions* o) { o->planes.kept_slack = -1; }},
       {"PlaneSearchOptions::max_planes_per_triangle is 0, allowed: 1 or above",
        [](StepOptions* o) { o->planes.max_planes_per_triangle = 0; }},
       {"VolumeOptions::tolerance is 0, allowed: above 0",
        [](StepOptions* o) { o->volume.tolerance = 0; }},
       {"VolumeOptions::max_steps is 0, allowed: 1 or above",
        [](StepOptions* o) { o->volume.max_steps = 0; }},
       {"VolumeOptions::smoothing_passes is -1, allowed: 0 or above",
        [](StepOptions* o) { o->volume.smoothing_passes = -1; }},
       {"DefectOptions::sheet_fraction is 3, allowed: 0 to 1",
        [](StepOptions* o) { o->defects.sheet_fraction = 3; }},
       {"DefectOptions::stiffening is 0.5, allowed: 1 or above",
        [](StepOptions* o) { o->defects.stiffening = 0.5; }},
       {"DefectOptions::max_folded_fraction is -1, allowed: 0 to 1",
        [](StepOptions* o) { o->defects.max_folded_fraction = -1; }}});
}

TEST(StepOptions, NameTheFieldOfTheRelaxationThatIsWrong) {
  ExpectAllRefused(
      {{"RelaxationOptions::smoothing_length is 0, allowed: above 0",
        [](StepOptions* o) { o->relaxation.smoothing_length = 0; }},
       {"RelaxationOptions::strain_hardening is -1, allowed: 0 or above",
        [](StepOptions* o) { o->relaxation.strain_hardening = -1; }},
       {"RelaxationOptions::stretch_limit is 0.9, allowed: 1 or above",
        [](StepOptions* o) { o->relaxation.stretch_limit = 0.9; }},
       {"RelaxationOptions::rope_factor is -1, allowed: 0 or above",
        [](StepOptions* o) { o->relaxation.rope_factor = -1; }},
       {"RelaxationOptions::full_sweep_interval is 0, allowed: 1 or above",
        [](StepOptions* o) { o->relaxation.full_sweep_interval = 0; }},
       {"RelaxationOptions::level_interval is 0, allowed: 1 or above",
        [](StepOptions* o) { o->relaxation.level_interval = 0; }},
       {"RelaxationOptions::max_push is 0, allowed: above 0",
        [](StepOptions* o) { o->relaxation.max_push = 0; }},
       {"RelaxationOptions::room_decay is 1.1, allowed: 0 to 1",
        [](StepOptions* o) { o->relaxation.room_decay = 1.1; }},
       {"RelaxationOptions::violation_weight is 0, allowed: above 0",
        [](StepOptions* o) { o->relaxation.violation_weight = 0; }},
       {"RelaxationOptions::bone_turns is 0, allowed: 1 or above",
        [](StepOptions* o) { o->relaxation.bone_turns = 0; }}});
}

// Two vertices that are beyond their planes by all that is allowed still keep
// the gap.
TEST(StepOptions, TheGapIsKeptIfViolationsAreAllowed) {
  StepOptions options;
  options.gap = 0.3;
  EXPECT_GT(options.AllowedViolation(), 0);
  EXPECT_NEAR(options.AimedGap() - 2 * options.AllowedViolation(), 0.3, 1e-15);
}

}  // namespace
}  // namespace musclewarp
