// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/frame_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "figures/some_figures.h"
#include "musclewarp/figures/figures_json.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

FrameFigures ReadBack(const OrderedJson& json) {
  FrameFigures figures;
  ReadJson(json, {}, &figures);
  return figures;
}

TEST(FrameFigures, ComeBackToTheBit) {
  const FrameFigures figures = SomeFigures(3);
  const OrderedJson json = JsonOf(figures);
  EXPECT_TRUE(AreEqual(ReadBack(json), figures));
  // Through text as well: every double is written so that it reads the same.
  const FrameFigures through_text = ReadBack(OrderedJson::parse(json.dump()));
  EXPECT_TRUE(AreEqual(through_text, figures));
  EXPECT_EQ(JsonOf(through_text).dump(), json.dump());
}

TEST(FrameFigures, OfLongRunsComeBack) {
  std::vector<FrameFigures> frames(100000);
  for (size_t i = 0; i < frames.size(); ++i) {
    frames[i].time = 1.0 / static_cast<double>(i + 1);
  }
  std::vector<FrameFigures> read;
  ReadJson(JsonOf(frames), {}, &read);
  EXPECT_TRUE(AreEqual(read, frames));
}

TEST(FrameFigures, NameTheSmallestGap) {
  FrameFigures figures = SomeFigures(0);
  figures.intersections.gaps.erase(figures.intersections.gaps.begin());
  EXPECT_EQ(JsonOf(figures)["smallest_gap_mm"], 1.0 / 3);
  figures.intersections.gaps.clear();
  EXPECT_TRUE(JsonOf(figures)["smallest_gap_mm"].is_null());
}

TEST(FrameFigures, HaveStagesOnlyIfTheyWereRecorded) {
  FrameFigures figures = SomeFigures(0);
  EXPECT_TRUE(JsonOf(figures).contains("stages"));
  figures.stages.clear();
  const OrderedJson json = JsonOf(figures);
  EXPECT_FALSE(json.contains("stages"));
  EXPECT_TRUE(AreEqual(ReadBack(json), figures));
}

TEST(FrameFigures, AreUsableIfEverySolveConvergedAndNothingIsShort) {
  FrameFigures figures = SomeFigures(0);
  figures.muscles.push_back(figures.muscles[0]);
  EXPECT_TRUE(figures.IsUsable());
  EXPECT_EQ(figures.stop_reason(), "converged");
  EXPECT_EQ(figures.iterations(), 34);
  figures.muscles[1].name = "second";
  figures.muscles[1].solver.stop_reason = StopReason::kIterationLimit;
  EXPECT_FALSE(figures.IsUsable());
  EXPECT_EQ(figures.stop_reason(), "iteration_limit (second)");
  figures.muscles.pop_back();
  figures.shortcomings = {"crosses a bone"};
  EXPECT_FALSE(figures.IsUsable());
  EXPECT_EQ(figures.stop_reason(), "converged");
}

TEST(FrameFigures, OfAFrameLeaveItsListsOut) {
  FrameFigures frame = SomeFigures(2);
  frame.intersections.pairs[0].triangles_of_a = {1, 2};
  frame.intersections.inside_of_muscles = {{3}};
  frame.muscles[0].solver.history.resize(4);
  const FrameFigures figures = FiguresOf(frame);
  EXPECT_TRUE(AreEqual(figures, frame));
  EXPECT_TRUE(figures.intersections.pairs[0].triangles_of_a.empty());
  EXPECT_TRUE(figures.intersections.inside_of_muscles.empty());
  EXPECT_TRUE(figures.muscles[0].solver.history.empty());
}

}  // namespace
}  // namespace musclewarp
