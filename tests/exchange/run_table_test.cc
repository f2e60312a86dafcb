// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/run_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "musclewarp/base/text.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Row = std::map<std::string, std::string>;

// A run of two frames of a ball of muscle with the line "l".
class RunTable : public ::testing::Test {
 protected:
  RunTable() : run_(WriteRun(TestTempDir())) {
    for (auto& frame : run_.report["frames"]) {
      frame["moment_arms_converged"] = true;
    }
  }

  std::string Text() {
    run_.WriteReport();
    const JsonField report = ReadReport(run_.dir);
    return RunTableText(OutlineOf(run_.dir, report),
                        TableCoordinatesOf(report),
                        {0, 1},
                        [](int) {});
  }

  // Rows by the names of their columns. No field has a comma.
  std::vector<Row> Rows() {
    const std::vector<std::string> lines = Split(Text(), '\n');
    const std::vector<std::string> names = Split(lines[0], ',');
    std::vector<Row> rows;
    for (size_t i = 1; i < lines.size(); ++i) {
      if (lines[i].empty()) continue;
      const std::vector<std::string> fields = Split(lines[i], ',');
      EXPECT_EQ(fields.size(), names.size()) << lines[i];
      Row& row = rows.emplace_back();
      for (size_t k = 0; k < names.size(); ++k) row[names[k]] = fields[k];
    }
    return rows;
  }

  WrittenRun run_;
};

TEST_F(RunTable, HasTheUnitsInItsHeader) {
  EXPECT_EQ(Split(Text(), '\n')[0],
            "frame,name,time_s,hip_degrees,muscle,line,length_mm,moment_arm_"
            "hip_mm,volume_mm3,largest_section_area_mm2");
}

TEST_F(RunTable, HasTheFiguresOfTheReport) {
  const std::vector<Row> rows = Rows();
  ASSERT_EQ(rows.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    Row row = rows[i];
    EXPECT_EQ(row["frame"], std::to_string(i));
    EXPECT_EQ(row["name"], "\"t=0.1 \"\"quoted\"\"\"");
    EXPECT_EQ(row["muscle"], "muscle");
    EXPECT_EQ(row["line"], "l");
    EXPECT_EQ(row["hip_degrees"], std::to_string(10 * i));
    EXPECT_EQ(std::stod(row["time_s"]), 0.1 + i);
    EXPECT_EQ(std::stod(row["length_mm"]), 100 + i);
    // Nine digits.
    EXPECT_NEAR(std::stod(row["moment_arm_hip_mm"]), 20.0 / 3, 1e-8);
    EXPECT_NEAR(std::stod(row["volume_mm3"]), 2e5 / 7, 1e-4);
  }
}

TEST_F(RunTable, LeavesOutWhatIsNotKnown) {
  run_.report["frames"][0]["moment_arms_converged"] = false;
  auto& second = run_.report["frames"][1];
  second["muscles"][0]["line_moment_arms_mm"] = nlohmann::json::object();
  second["time"] = 0;  // as of poses that are no motion
  second["coordinates"] = nlohmann::json::object();
  for (Row& row : Rows()) {
    EXPECT_EQ(row["moment_arm_hip_mm"], "");
    EXPECT_EQ(row["time_s"], "");
    EXPECT_NE(row["volume_mm3"], "");
  }
  EXPECT_EQ(Rows()[1]["hip_degrees"], "");
}

TEST_F(RunTable, HasARowForAMuscleWithoutLines) {
  run_.report["frames"][1]["muscles"][0]["line_lengths_mm"] =
      nlohmann::json::object();
  std::vector<Row> rows = Rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1]["line"], "");
  EXPECT_EQ(rows[1]["length_mm"], "");
  EXPECT_EQ(rows[1]["volume_mm3"], rows[0]["volume_mm3"]);
}

TEST_F(RunTable, HasColumnsForCoordinatesThatMove) {
  run_.report["motion"]["coordinates"] = {
      {{"name", "tx"}, {"unit", "m"}, {"moves", true}},
      {{"name", "any"}, {"unit", ""}, {"moves", false}}};
  EXPECT_THAT(Split(Text(), '\n')[0],
              HasSubstr("time_s,tx_m,any,muscle,line,length_mm,"
                        "moment_arm_tx_mm_per_m,volume_mm3"));
  run_.report["motion"] = nullptr;
  EXPECT_THAT(Split(Text(), '\n')[0],
              HasSubstr("time_s,muscle,line,length_mm,volume_mm3"));
}

TEST_F(RunTable, KeepsNamesFromBeingFormulas) {
  WrittenRun run = WriteRun(TestTempDir() + "/named", "=1+1");
  run.report["motion"]["coordinates"][0]["name"] = "@hip";
  run.WriteReport();
  const JsonField report = ReadReport(run.dir);
  const std::string text = RunTableText(
      OutlineOf(run.dir, report), TableCoordinatesOf(report), {0}, [](int) {});
  EXPECT_THAT(text, HasSubstr(",'@hip_degrees,"));
  EXPECT_THAT(text, HasSubstr(",'=1+1,l,"));
}

TEST_F(RunTable, NamesADamagedField) {
  run_.report["motion"]["coordinates"][0].erase("moves");
  ExpectInputError([&] { Text(); }, {"motion.coordinates[0].moves"});
}

TEST(LargestSectionOfMuscle, IsTheWaistOfASpindle) {
  const TriangleSoup muscle = Spindle(8, 60, 4);
  // Within 1 % of an ellipsoid, in which the mesh is.
  const double area = LargestSectionOfMuscle(muscle, {});
  EXPECT_NEAR(area, 64 * M_PI, 0.64 * M_PI);
  // Lines on both sides of the axis have it as their mean.
  Points left(2, 3), right(2, 3);
  left << -4, 0, -50, -4, 0, 50;
  right << 4, 0, -50, 4, 0, 50;
  EXPECT_NEAR(LargestSectionOfMuscle(muscle, {{"l", left}, {"r", right}}),
              area,
              0.001 * area);
}

}  // namespace
}  // namespace musclewarp
