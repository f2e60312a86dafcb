// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/frame_record.h"

#include <gtest/gtest.h>

#include "report/records.h"

namespace musclewarp {
namespace {

TEST(FrameRecord, ComesBackToTheBit) {
  const auto json = ToJson(SomeRecord(3));
  EXPECT_EQ(ToJson(FrameRecordFromJson(json)), json);
  // Through text as well: every double is written so that it reads the same.
  EXPECT_EQ(
      ToJson(FrameRecordFromJson(nlohmann::ordered_json::parse(json.dump()))),
      json);
}

TEST(FrameRecord, NamesTheSmallestGap) {
  FrameRecord record = SomeRecord(0);
  record.intersections.gaps.erase(record.intersections.gaps.begin());
  EXPECT_EQ(ToJson(record)["smallest_gap_mm"], 1.0 / 3);
  record.intersections.gaps.clear();
  EXPECT_TRUE(ToJson(record)["smallest_gap_mm"].is_null());
}

TEST(FrameRecord, ReadsReportsThatHaveNoGapsYet) {
  auto json = ToJson(SomeRecord(3));
  json.erase("gaps");
  json.erase("smallest_gap_mm");
  const FrameRecord record = FrameRecordFromJson(json);
  EXPECT_TRUE(record.intersections.gaps.empty());
  EXPECT_EQ(record.intersections.pairs.size(), 1u);
}

TEST(FrameRecord, SumsOverMuscles) {
  FrameRecord record = SomeRecord(0);
  record.muscles.push_back(record.muscles[0]);
  record.muscles[1].volume_error = -0.25;
  EXPECT_EQ(record.FoldedTriangles(), 6);
  EXPECT_EQ(record.WorstVolumeError(), 0.25);
}

}  // namespace
}  // namespace musclewarp
