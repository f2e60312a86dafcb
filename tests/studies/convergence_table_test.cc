// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

ConvergenceRow RowWith(double value, double largest, double mean) {
  ConvergenceRow row;
  row.value = value;
  row.pose = "flexion, 60";
  row.muscle = "psoas";
  row.largest_distance = largest;
  row.mean_distance = mean;
  return row;
}

// Hulls of 200 vertices as set, in two frames, the finest, and one that failed.
std::vector<ConvergenceRow> StudiedRows() {
  std::vector<ConvergenceRow> rows = {
      RowWith(200, 1.25, 0.5), RowWith(200, 6.875, 0.25), RowWith(1200, 0, 0)};
  rows[0].is_as_set = rows[1].is_as_set = true;
  rows[2].is_finest = true;
  rows[2].moment_arm_difference = 0;
  ConvergenceRow failed;
  failed.value = 2400;
  failed.failure = "no \"room\"";
  rows.push_back(failed);
  return rows;
}

}  // namespace

TEST(ConvergenceTable, SaysTheErrorOfWhatIsSetInAllFrames) {
  std::ostringstream errors;
  PrintErrors(StudiedRows(), errors);
  EXPECT_EQ(errors.str(),
            "psoas: hulls of 200 vertices: 0.50 mm on the mean, 6.88 mm at "
            "most, from 1200\n");
  std::vector<ConvergenceRow> finest = {RowWith(200, 0, 0)};
  finest[0].is_as_set = finest[0].is_finest = true;
  std::ostringstream none;
  PrintErrors(finest, none);
  EXPECT_EQ(none.str(),
            "psoas: hulls of 200 vertices: the finest of the study\n");
}

TEST(ConvergenceTable, AFailedDiscretisationIsARowThatSaysSo) {
  std::ostringstream table;
  PrintConvergence(StudiedRows(), table);
  EXPECT_THAT(table.str(), HasSubstr("2400  failed: no \"room\""));
  const auto json = ConvergenceJson(StudiedRows());
  ASSERT_EQ(json.size(), 4u);
  EXPECT_EQ(json[3]["failure"], "no \"room\"");
  EXPECT_FALSE(json[3].contains("ms"));
  EXPECT_TRUE(json[0]["moment_arm_difference_mm"].is_null());
  EXPECT_EQ(json[2]["moment_arm_difference_mm"], 0);
}

TEST(ConvergenceTable, CsvHasTheSameFieldsInEveryRow) {
  std::istringstream lines(ConvergenceCsv(StudiedRows()));
  std::string header, row, failed;
  std::getline(lines, header);
  std::getline(lines, row);
  for (int skipped = 0; skipped < 3; ++skipped) std::getline(lines, failed);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  // The comma of the pose is in quotes.
  EXPECT_EQ(commas(row), commas(header) + 1);
  EXPECT_EQ(commas(failed), commas(header));
  EXPECT_THAT(failed, HasSubstr("\"no \"\"room\"\"\""));
}

}  // namespace musclewarp
