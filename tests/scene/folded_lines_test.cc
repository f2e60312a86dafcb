// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/folded_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/base/angles.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A line beside a joint at the origin, which two poses close by these angles,
// in degrees.
Scene BesideAJoint(double first, double second) {
  Scene scene;
  SceneMuscle& muscle = scene.muscles.emplace_back();
  muscle.name = "brachialis";
  ActionLine& line = muscle.lines.emplace_back();
  line.name = "elbow";
  line.rest = Points::Zero(4, 3);
  line.rest.col(0) << -20, -10, 10, 20;
  line.rest.col(1).setConstant(10);
  line.bodies = {"humerus", "humerus", "ulna", "ulna"};
  for (const double degrees : {first, second}) {
    const double angle = RadiansOf(degrees);
    ScenePose& pose = scene.poses.emplace_back();
    pose.name = "closed by " + std::to_string(static_cast<int>(degrees));
    Eigen::Matrix4d& ulna = pose.bodies["ulna"];
    ulna.setIdentity();
    ulna.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle),
        std::sin(angle), std::cos(angle);
  }
  return scene;
}

TEST(FoldedLineWarnings, NameTheLineAndTheWorstPose) {
  // The points beside the joint meet at 90 degrees. Right after, the segment
  // between them points against those beside it: at 90 + x degrees they turn
  // by 135 - x / 2.
  EXPECT_THAT(FoldedLineWarnings(BesideAJoint(110, 100)),
              ElementsAre(AllOf(HasSubstr("line elbow of muscle brachialis"),
                                HasSubstr("in pose closed by 100, by 130"),
                                HasSubstr("slide"))));
}

TEST(FoldedLineWarnings, ProposeToSlideOnlyWhereTheLineCould) {
  Scene scene = BesideAJoint(110, 100);
  const ActionLine& line = scene.muscles[0].lines[0];
  for (ScenePose& pose : scene.poses) {
    pose.lines[line.name] = LineTargets({line}, pose)[0].points;
  }
  EXPECT_THAT(FoldedLineWarnings(scene),
              ElementsAre(AllOf(HasSubstr("leave out points"),
                                Not(HasSubstr("slide")))));
}

TEST(FoldedLineWarnings, AreNotGivenForLinesThatOnlyBend) {
  EXPECT_THAT(FoldedLineWarnings(BesideAJoint(0, 60)), IsEmpty());
}

TEST(FoldedLineWarnings, AreNotGivenForLinesThatSlide) {
  Scene scene = BesideAJoint(110, 100);
  scene.muscles[0].lines[0].slides = true;
  EXPECT_THAT(FoldedLineWarnings(scene), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
