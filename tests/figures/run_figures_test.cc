// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/run_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figures/some_figures.h"
#include "musclewarp/figures/figures_json.h"

namespace musclewarp {
namespace {

// Three frames of two muscles each, with other figures in each.
std::vector<FrameFigures> SomeFrames() {
  std::vector<FrameFigures> frames;
  for (int i = 0; i < 3; ++i) {
    frames.push_back(SomeFigures(i));
    frames[i].muscles.push_back(frames[i].muscles[0]);
    frames[i].muscles[1].volume_error = i == 1 ? -0.25 : 0.1;
    frames[i].muscles[0].folded_triangles = 5 * i;
    frames[i].wall_ms = 7 - i;
  }
  frames[2].intersections = {};
  return frames;
}

TEST(RunFigures, SumUpFrames) {
  const RunFigures run = FiguresOf(SomeFrames(), 4, false, "disk full");
  EXPECT_EQ(run.frames, 3);
  EXPECT_EQ(run.frames_clean, 1);
  EXPECT_EQ(run.worst_volume_error, 0.25);
  EXPECT_EQ(run.worst_folded_triangles, 10);
  EXPECT_EQ(run.wall_ms_per_frame_median, 6);
  EXPECT_EQ(run.frames_planned, 4);
  EXPECT_EQ(run.stopped, "disk full");
  EXPECT_TRUE(run.usable);
}

TEST(RunFigures, DoNotDependOnTheOrderOfFramesAndMuscles) {
  std::vector<FrameFigures> frames = SomeFrames();
  const RunFigures run = FiguresOf(frames, 3, true, "");
  std::reverse(frames.begin(), frames.end());
  for (FrameFigures& frame : frames) {
    std::reverse(frame.muscles.begin(), frame.muscles.end());
  }
  EXPECT_TRUE(AreEqual(FiguresOf(frames, 3, true, ""), run));
}

TEST(RunFigures, AreNotUsableIfAFrameIsNotOrThereIsNone) {
  std::vector<FrameFigures> frames = SomeFrames();
  frames[1].shortcomings = {"crosses a bone"};
  EXPECT_FALSE(FiguresOf(frames, 3, true, "").usable);
  EXPECT_FALSE(FiguresOf({}, 3, false, "").usable);
}

// A figure that could not be computed must not pass for a small one.
TEST(RunFigures, KeepWhatIsNoNumber) {
  std::vector<FrameFigures> frames = SomeFrames();
  frames[0].muscles[0].volume_error = std::nan("");
  EXPECT_TRUE(std::isnan(FiguresOf(frames, 3, true, "").worst_volume_error));
}

TEST(RunFigures, ComeBack) {
  for (const std::string stopped : {"", "a \"quoted\"\nreason"}) {
    const RunFigures run = FiguresOf(SomeFrames(), 4, false, stopped);
    const auto json = nlohmann::ordered_json::parse(JsonOf(run).dump());
    EXPECT_EQ(json.at("stopped").is_null(), stopped.empty());
    RunFigures read;
    ReadJson(json, {}, &read);
    EXPECT_TRUE(AreEqual(read, run));
  }
}

}  // namespace
}  // namespace musclewarp
