// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/shape_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "figures/some_figures.h"
#include "musclewarp/frames/triangle_stretch.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Three frames of a muscle whose second attachment leaves its body so far, mm.
std::vector<FrameFigures> Frames(double first, double second, double third) {
  std::vector<FrameFigures> frames;
  for (const double drift : {first, second, third}) {
    FrameFigures& frame =
        frames.emplace_back(SomeFigures(static_cast<int>(frames.size())));
    frame.name = "pose " + std::to_string(frames.size());
    frame.bone_overlaps.clear();
    frame.muscles[0].name = "psoas";
    frame.muscles[0].attachments = {
        {"pelvis", 3, 0.1, 0.2, {0, 0, 0}},
        {"femur", 4, drift / 10, drift, {1, 2, drift}}};
  }
  return frames;
}

TEST(ShapeWarnings, NameTheWorstFrameOfAnAttachment) {
  EXPECT_THAT(
      ShapeWarnings(Frames(2.5, 4, 3)),
      ElementsAre("psoas leaves femur, to which it is attached, by up to 4.0 "
                  "mm (0.4 on average) in pose 2 at (1.0, 2.0, 4.0)"));
}

TEST(ShapeWarnings, OfDriftAreGivenBeyondTwoMillimetresOnly) {
  EXPECT_THAT(ShapeWarnings(Frames(0, 2, 1)), IsEmpty());
  EXPECT_THAT(ShapeWarnings({}), IsEmpty());
}

TEST(ShapeWarnings, NameTheFrameOfTheLargestStretch) {
  std::vector<FrameFigures> frames = Frames(0, 0, 0);
  for (FrameFigures& frame : frames) {
    frame.muscles[0].shape.triangles = StretchMeasures();
  }
  frames[0].muscles[0].shape.max_stretch = kStretchBeyondAnatomy;
  EXPECT_THAT(ShapeWarnings(frames), IsEmpty());
  frames[1].muscles[0].shape.max_stretch = 1.8;
  frames[1].muscles[0].shape.stretch_place << 3, 2, 1;
  frames[2].muscles[0].shape.max_stretch = 1.7;
  EXPECT_THAT(ShapeWarnings(frames),
              ElementsAre("psoas is stretched to 1.80 times its length at rest "
                          "in pose 2 at (3.0, 2.0, 1.0)"));
}

TEST(ShapeWarnings, SayHowMuchOfASurfaceIsStretched) {
  std::vector<FrameFigures> frames = Frames(0, 0, 0);
  ShapeMeasures& shape = frames[1].muscles[0].shape;
  shape.max_stretch = 2.3;
  shape.stretch_place << 3, 2, 1;
  shape.triangles = StretchMeasures();
  shape.triangles.largest = 2.4;
  shape.triangles.quantile_99 = 1.2;
  shape.triangles.quantile_999 = 1.55;
  const std::string single =
      "psoas is stretched to 2.30 times its length at rest in pose 2 at (3.0, "
      "2.0, 1.0), 99 % of its surface to at most 1.20, 99.9 % to 1.55";
  EXPECT_THAT(ShapeWarnings(frames), ElementsAre(single));
  shape.triangles.largest_patch = 35;
  shape.triangles.patch_place << 4, 5, 6;
  EXPECT_THAT(ShapeWarnings(frames),
              ElementsAre(single + "; the largest patch beyond 2 has 0.35 cm2, "
                                   "at (4.0, 5.0, 6.0)"));
}

TEST(ShapeWarnings, NameTheFrameWhereBonesAreDeepest) {
  std::vector<FrameFigures> frames = Frames(0, 0, 0);
  frames[1].bone_overlaps = {{"pelvis", "femur", 3.7, {1, 2, 3}},
                             {"patella", "femur", 0.5, {4, 5, 6}}};
  frames[2].bone_overlaps = {{"pelvis", "femur", 3.6, {7, 8, 9}}};
  EXPECT_THAT(
      ShapeWarnings(frames),
      ElementsAre("patella and femur are 0.5 mm deep in each other in pose 2 "
                  "at (4.0, 5.0, 6.0): muscles between them have no room there",
                  "pelvis and femur are 3.7 mm deep in each other in pose 2 at "
                  "(1.0, 2.0, 3.0): muscles between them have no room there"));
}

// A motion of six frames, with the largest change of a muscle in each, mm.
std::vector<FrameFigures> Motion(const std::vector<double>& changes) {
  std::vector<FrameFigures> frames;
  for (const double change : changes) {
    FrameFigures& frame =
        frames.emplace_back(SomeFigures(static_cast<int>(frames.size())));
    frame.name = "t=" + std::to_string(frames.size());
    frame.muscles[0].name = "psoas";
    frame.muscles[0].attachments.clear();
    frame.bone_overlaps.clear();
    frame.muscles[0].shape = ShapeMeasures();
    frame.muscles[0].shape.max_change = change;
  }
  return frames;
}

TEST(ShapeWarnings, NameJumps) {
  EXPECT_THAT(ShapeWarnings(Motion({60, 2, 2, 2, 7, 2})),
              ElementsAre("psoas jumps by 7.0 mm from t=4 to t=5 (the median "
                          "of its changes is 2.0 mm) at (0.0, 0.0, 0.0)"));
  // Neither the way to the first frame, nor steady changes, nor small ones.
  EXPECT_THAT(ShapeWarnings(Motion({60, 2, 3, 4, 5, 6})), IsEmpty());
  EXPECT_THAT(ShapeWarnings(Motion({0, 0.1, 0.1, 0.1, 0.9, 0.1})), IsEmpty());
  EXPECT_THAT(ShapeWarnings(Motion({60, 1, 1, 50})), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
