// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/remedies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "figures/some_figures.h"
#include "musclewarp/certificate/shortcomings.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A run of usable frames with these indices.
RunRecord UsableRun(const std::vector<int>& indices) {
  RunRecord run;
  for (const int index : indices) {
    FrameFigures frame;
    frame.index = index;
    run.frames.push_back(frame);
  }
  return run;
}

// A muscle that breaks every requirement on single muscles.
JudgedMuscle BadMuscle() {
  JudgedMuscle judged;
  MuscleFigures& figures = judged.figures;
  figures.name = "m";
  figures.volume_error = 1;
  figures.volume_ratio = 0.5;
  figures.shape.max_stretch = 100;
  figures.self_pairs = 2;
  figures.torn_patch.area = 1e4;
  figures.folded_triangles = 50;
  figures.max_contact_displacement = 1e3;
  judged.num_triangles = 100;
  judged.reconstruction.gone_area = 1e4;
  judged.reconstruction.lost_extent = 100;
  judged.reconstruction.lost_attachments = {"femur"};
  return judged;
}

TEST(RemediesFor, AUsableRunAreNone) {
  EXPECT_THAT(RemediesFor(UsableRun({0, 1})), IsEmpty());
}

TEST(RemediesFor, NameTheFramesBeforeTheFirstBadOneAndTheirFlag) {
  const auto first_line = [](const std::vector<int>& indices, size_t bad) {
    RunRecord run = UsableRun(indices);
    run.frames[bad].shortcomings = {"m: 4 folded triangles, allowed 0"};
    const std::vector<std::string> lines = RemediesFor(run);
    EXPECT_THAT(lines.back(), HasSubstr("folded triangles"));
    return lines.front();
  };
  EXPECT_THAT(first_line({0, 1, 2, 3}, 3),
              HasSubstr("frames 0 to 2 are usable: {frames}=0:2 "));
  EXPECT_THAT(first_line({0, 1, 2, 3}, 1),
              HasSubstr("frame 0 is usable: {frames}=0 "));
  EXPECT_THAT(first_line({4, 6, 8, 10}, 3),
              HasSubstr("frames 4 to 8 are usable: {frames}=4:8:2 "));
  // The last of a range with steps may be nearer: no flag has these alone.
  EXPECT_THAT(first_line({0, 5, 6, 7}, 3), Not(HasSubstr("{frames}")));
  EXPECT_THAT(first_line({0, 1}, 0), Not(HasSubstr("usable")));
}

TEST(RemediesFor, SayEachKindOnce) {
  RunRecord run = UsableRun({0, 1, 2});
  for (FrameFigures& frame : run.frames) {
    frame.shortcomings = {"a: 4 folded triangles, allowed 0",
                          "b: 7 folded triangles, allowed 0"};
  }
  EXPECT_THAT(RemediesFor(run), ElementsAre(HasSubstr("folded triangles")));
}

// The sentences are found by their words: if one is worded anew, this fails.
TEST(RemedyFor, KnowsEverySentenceOfTheCertificate) {
  FrameRequirements requirements;
  requirements.max_torn_patch = 1;
  requirements.gap = 0.1;
  SceneIntersections intersections;
  PairFigures pair;
  pair.a = "m";
  pair.b = "femur";
  pair.triangle_pairs = 1;
  intersections.pairs = {pair};
  intersections.gaps = {{"m", "femur", 0.01, 0.02, {1, 2, 3}}};
  const std::vector<std::string> sentences =
      Shortcomings(requirements, intersections, {BadMuscle()});
  EXPECT_EQ(sentences.size(), 12u);  // each requirement that there is
  std::vector<std::string> remedies;
  for (const std::string& sentence : sentences) {
    remedies.push_back(RemedyFor(sentence));
    EXPECT_NE(remedies.back(), "") << sentence;
  }
  for (const char* flag : {"{gap}",
                           "{max_loss}",
                           "{max_lost_area}",
                           "{max_lost_extent}",
                           "{max_torn_patch}"}) {
    EXPECT_THAT(remedies, ::testing::Contains(HasSubstr(flag)));
  }
}

}  // namespace
}  // namespace musclewarp
