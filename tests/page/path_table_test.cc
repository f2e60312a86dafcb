// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/path_table.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson FitOf(const OrderedJson& held_back) {
  return {{"max_length_error_mm", 0.5},
          {"max_arm_error_mm", 1},
          {"largest_arm_error_mm", 5},
          {"frames", 20},
          {"frames_doubtful", {"a"}},
          {"frames_left_out", {"b", "c"}},
          {"microseconds", 2.5},
          {"muscles",
           {{"psoas_r",
             {{"muscle", "psoas_major_r"},
              {"coordinates", {"hip_flexion_r", "hip_rotation_r"}},
              {"terms", 31},
              {"held_back", held_back},
              {"lines_through_range",
               {{"lines", 500}, {"jumps", 0}, {"with_sign_change", 4}}},
              {"within_bounds", true}}}}}};
}

std::string Written(const OrderedJson& fit) {
  const std::string file = TestTempDir() + "/fit.json";
  WriteTextAtomically(file, fit.dump());
  return file;
}

TEST(PathTable, HasARowForEachFunction) {
  const OrderedJson errors = {
      {"mean", 0.1}, {"quantile_95", 0.3}, {"largest", 0.7}};
  const OrderedJson table = PathTableOf(
      Written(FitOf({{"length_error_mm", errors}, {"arm_error_mm", errors}})));
  EXPECT_EQ(table.at("file"), "fit.json");
  EXPECT_EQ(table.at("frames_left_out"), 2);
  EXPECT_EQ(table.at("bounds_mm"), OrderedJson({0.5, 1, 5}));
  ASSERT_EQ(table.at("rows").size(), 1u);
  const OrderedJson& row = table.at("rows")[0];
  EXPECT_EQ(row.at("name"), "psoas_r");
  EXPECT_EQ(row.at("coordinates").size(), 2u);
  EXPECT_EQ(row.at("arm_mm"), OrderedJson({0.1, 0.3, 0.7}));
}

TEST(PathTable, SaysWhereNothingWasHeldBack) {
  const OrderedJson table = PathTableOf(Written(FitOf(nullptr)));
  EXPECT_TRUE(table.at("rows")[0].at("arm_mm").is_null());
}

TEST(PathTable, RefusesOtherFiles) {
  OrderedJson fit = FitOf(nullptr);
  fit["muscles"]["psoas_r"].erase("terms");
  ExpectInputError([&] { PathTableOf(Written(fit)); },
                   {"fit.json", "psoas_r", "terms"});
  ExpectInputError(
      [&] {
        PathTableOf(Written({{"frames", 3}}));
      },
      {"fit.json", "muscles"});
}

}  // namespace
}  // namespace musclewarp
