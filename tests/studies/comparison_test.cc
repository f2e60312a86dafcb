// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

ComparisonRow FailedRow() {
  ComparisonRow row;
  row.pose = "flexion, 60";
  row.configuration = "ceres_sparse_cholesky";
  row.contact = "none";
  row.stop_reason = "failed: \"no\" library";
  return row;
}

}  // namespace

TEST(Comparison, AFailureIsARowThatSaysSo) {
  std::ostringstream table;
  PrintComparison({FailedRow()}, table);
  EXPECT_THAT(table.str(), HasSubstr("ceres_sparse_cholesky"));
  EXPECT_THAT(table.str(), HasSubstr("failed: \"no\" library"));
  const auto json = ComparisonJson({FailedRow()}, PreparedScene());
  EXPECT_EQ(json["rows"][0]["was_run"], false);
  EXPECT_FALSE(json["rows"][0].contains("ms"));
}

TEST(Comparison, CsvHasTheSameFieldsInEveryRow) {
  ComparisonRow row;
  row.was_run = true;
  row.stop_reason = "converged";
  const std::string csv = ComparisonCsv({row, FailedRow()});
  std::istringstream lines(csv);
  std::string header, good, failed;
  std::getline(lines, header);
  std::getline(lines, good);
  std::getline(lines, failed);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(good), commas(header));
  // One comma is quoted with the pose; quotes inside quotes are doubled.
  EXPECT_EQ(commas(failed), commas(header) + 1);
  EXPECT_THAT(failed, HasSubstr("\"flexion, 60\""));
  EXPECT_THAT(failed, HasSubstr("\"failed: \"\"no\"\" library\""));
}

TEST(Comparison, HistoryHasALineAnIteration) {
  PreparedScene scene;
  scene.muscles.resize(1);
  scene.muscles[0].model.name = "muscle";
  ComparisonRow row;
  row.was_run = true;
  row.muscles.resize(1);
  row.muscles[0].history = {{0.5, 0.01, 0.125, false}, {0.25, 0.001, 1, true}};
  const std::string csv = HistoryCsv({row, FailedRow()}, scene);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_THAT(csv, HasSubstr("muscle,1,0.5,0.01,0.125,coarse\n"));
  EXPECT_THAT(csv, HasSubstr("muscle,2,0.25,0.001,1,fine\n"));
}

}  // namespace musclewarp
