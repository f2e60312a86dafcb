// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/screen_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "figures/some_figures.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

// A finished run of two usable frames, in which meshes cross.
RunRecord CrossingRun(ContactKind contact) {
  RunRecord run;
  run.contact.kind = contact;
  run.frames = {SomeFigures(0), SomeFigures(1)};
  run.frames_planned = 2;
  run.finished = true;
  return run;
}

std::string LastLine(const RunRecord& run) {
  std::ostringstream screen;
  PrintFrames(run, screen);
  std::string text = screen.str();
  text = text.substr(0, text.find("\nwhat helps:"));
  text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

TEST(ScreenReport, SaysWhichCavitiesAreFilled) {
  RepairReport repairs;
  EXPECT_EQ(FilledCavities(repairs), "");
  repairs.dropped_pieces.resize(2);
  for (DroppedPiece& shell : repairs.dropped_pieces) {
    shell.reason = DropReason::kShell;
    shell.cavity = 1050;
  }
  EXPECT_EQ(FilledCavities(repairs), ", cavities of 2.1 cm3 filled");
}

TEST(ScreenReport, SaysThatARunWithoutContactWasNotTestedForCrossings) {
  EXPECT_THAT(LastLine(CrossingRun(ContactKind::kNone)),
              AllOf(HasSubstr("2 frames, not tested for crossings (contact "
                              "none), worst"),
                    Not(HasSubstr("without intersection")),
                    EndsWith(": usable")));
}

TEST(ScreenReport, SaysThatPaperContactToleratesCrossings) {
  RunRecord run = CrossingRun(ContactKind::kPaper);
  EXPECT_THAT(LastLine(run),
              HasSubstr("2 frames, 0 without intersection (contact paper does "
                        "not refuse them), worst"));
  for (FrameFigures& frame : run.frames) frame.intersections = {};
  EXPECT_THAT(LastLine(run), HasSubstr("2 frames, 2 without intersection, "));
}

TEST(ScreenReport, SaysOfCertifiedContactHowManyFramesAreClean) {
  RunRecord run = CrossingRun(ContactKind::kCertified);
  run.frames[0].intersections = {};
  run.frames[1].shortcomings = {"crosses a bone"};
  EXPECT_THAT(LastLine(run),
              AllOf(HasSubstr("2 frames, 1 without intersection, worst"),
                    EndsWith(": NOT usable")));
}

TEST(ScreenReport, SaysOfAStoppedRunThatItIsUsableSoFar) {
  RunRecord run = CrossingRun(ContactKind::kCertified);
  run.frames_planned = 15;
  run.finished = false;
  EXPECT_THAT(LastLine(run),
              AllOf(HasSubstr("2 of 15 frames, 0 without"),
                    EndsWith(": usable so far")));
  run.frames[1].shortcomings = {"crosses a bone"};
  EXPECT_THAT(LastLine(run), EndsWith(": NOT usable"));
}

TEST(ScreenReport, EndsWithWhatHelpsIfTheRunIsNotUsable) {
  RunRecord run = CrossingRun(ContactKind::kCertified);
  std::ostringstream usable;
  PrintFrames(run, usable);
  EXPECT_THAT(usable.str(), Not(HasSubstr("what helps")));
  run.frames[1].shortcomings = {"m: 4 folded triangles, allowed 0"};
  std::ostringstream screen;
  PrintFrames(run, screen);
  EXPECT_THAT(screen.str(),
              AllOf(HasSubstr("not usable:\n  frame 1, "),
                    HasSubstr("NOT usable\n\nwhat helps:\n  frame 0 is usable: "
                              "--frames=0 computes it alone\n  no flag")));
}

}  // namespace
}  // namespace musclewarp
