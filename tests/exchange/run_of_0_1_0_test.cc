// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A run that version 0.1.0 has written (tests/run/data) is read by everything
// that reads runs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "musclewarp/exchange/run_paths.h"
#include "musclewarp/page/page.h"
#include "musclewarp/run/run_files.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const char kRun[] = MUSCLEWARP_RUN_OF_0_1_0;

TEST(RunOf010, IsReadForThePage) {
  std::ostringstream log;
  const RecordedRun run = ReadRecordedRun(kRun, log);
  EXPECT_THAT(run.warnings, IsEmpty());
  ASSERT_THAT(run.frames, SizeIs(2));
  EXPECT_TRUE(run.frames[1].IsUsable());
  EXPECT_EQ(run.frames[1].name, "t=0.15");
  EXPECT_EQ(run.frames[1].muscles[2].fibre_lengths.size(), 2u);
  EXPECT_GT(run.frames[1].intersections.gaps.size(), 0u);
  EXPECT_GT(PageHtml({run}, {}).size(), 100000u);
}

TEST(RunOf010, IsReadForExports) {
  const RunOutline run = ReadRunForExport(kRun, "0.1.0");
  EXPECT_THAT(run.warnings, IsEmpty());
  EXPECT_THAT(run.names.bones, ElementsAre("pelvis", "femur_r"));
  ASSERT_THAT(run.frames, SizeIs(2));
  const RecordedPose rest = ReadRestPose(run.rest, run.names);
  EXPECT_THAT(ReadPose(run.frames[1].folder, run.names, rest).muscles,
              SizeIs(3));
}

TEST(RunOf010, IsReadForPathsOfOpenSim) {
  const RunPaths paths = ReadRunPaths({kRun}, "");
  ASSERT_THAT(paths.paths, SizeIs(7));
  EXPECT_THAT(paths.paths[0].samples, SizeIs(2));
  EXPECT_THAT(paths.paths[0].coordinates, SizeIs(3));
}

TEST(RunOf010, IsReadForPictures) {
  const RunFiles run = FindRunFiles(kRun, "0,last");
  EXPECT_THAT(run.frames, SizeIs(2));
  EXPECT_THAT(run.frames[1].bones_from_rest, SizeIs(2));
}

}  // namespace
}  // namespace musclewarp
