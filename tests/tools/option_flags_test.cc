// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/option_flags.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

std::string Message(const std::string& error) {
  return FlagError(error,
                   {{"HullOptions::count", "vertices"},
                    {"HullOptions::count_tolerance", "tolerance"}})
      .what();
}

TEST(FlagError, NamesTheFlagOfTheField) {
  EXPECT_EQ(Message("HullOptions::count is 5, allowed: 20 to 5000"),
            "--vertices: is 5; allowed: 20 to 5000");
}

TEST(FlagError, TellsFieldsApartWhoseNamesBeginAlike) {
  EXPECT_EQ(Message("HullOptions::count_tolerance is -1, allowed: above 0"),
            "--tolerance: is -1; allowed: above 0");
}

TEST(FlagError, LeavesFieldsWithoutAFlagAsTheyAre) {
  EXPECT_EQ(Message("HullOptions::wraps is 0, allowed: above 0"),
            "options: HullOptions::wraps is 0, allowed: above 0; see --help");
}

// Expects that the options of a run are refused, once changed, with the words.
void ExpectOptionsRefused(const std::function<void(DeformOptions*)>& change,
                          const std::vector<std::string>& words) {
  DeformOptions options;
  change(&options);
  ExpectInputError([&] { CheckValid(options); }, words);
}

TEST(CheckValid, AcceptsTheDefaults) { CheckValid(DeformOptions()); }

TEST(CheckValid, TellsHullsOfMusclesFromThoseOfBones) {
  ExpectOptionsRefused(
      [](DeformOptions* o) {
        o->deformer.prepare.muscle.hull.coarse_vertices = 19;
      },
      {"--coarse_vertices: is 19; allowed: 20 to 5000"});
  ExpectOptionsRefused(
      [](DeformOptions* o) {
        o->deformer.frames.paper.bone_hull.coarse_vertices = 19;
      },
      {"--bone_coarse_vertices: is 19"});
}

TEST(CheckValid, LooksIntoStructsThatNoFlagReaches) {
  ExpectOptionsRefused(
      [](DeformOptions* o) {
        o->deformer.prepare.repair.stitch_tolerance = -1;
      },
      {"RepairOptions::stitch_tolerance is -1"});
  ExpectOptionsRefused(
      [](DeformOptions* o) { o->deformer.prepare.repair.holes.max_edges = -1; },
      {"HoleLimits::max_edges is -1"});
  ExpectOptionsRefused(
      [](DeformOptions* o) { o->deformer.prepare.slivers.aspect = 2; },
      {"SliverLimits::aspect is 2", "0 to 1"});
  ExpectOptionsRefused(
      [](DeformOptions* o) { o->deformer.prepare.fibres.voxels = 5; },
      {"FibreOptions::voxels is 5"});
  ExpectOptionsRefused(
      [](DeformOptions* o) { o->deformer.frames.paper_limits.max_turn = 0; },
      {"StepLimits::max_turn is 0"});
  ExpectOptionsRefused(
      [](DeformOptions* o) { o->deformer.frames.certified.rest_sweeps = 0; },
      {"CertifiedContactOptions::rest_sweeps is 0"});
  ExpectOptionsRefused(
      [](DeformOptions* o) {
        o->deformer.frames.certified.separation.cell.voxel_size = 0;
      },
      {"MedialCellOptions::voxel_size is 0"});
  ExpectOptionsRefused(
      [](DeformOptions* o) { o->deformer.frames.paper.group.mask_memory = 0; },
      {"GroupContactOptions::mask_memory is 0"});
}

}  // namespace
}  // namespace musclewarp
