// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/continued_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>
#include <utility>

#include "fibres/ball_bones.h"
#include "musclewarp/base/angles.h"
#include "musclewarp/fibres/fibres.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/skeleton/polyline.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A muscle along z from 0 to 100 below its bone "femur", and soft parts beside
// it, with the lines and ends that preparation gives them.
class ContinueLinesTest : public ::testing::Test {
 protected:
  ContinueLinesTest() {
    bones_.Add("femur", {0, 0, 107});
    bones_.Add("foot", {0, 0, -77});
  }

  void AddPart(const TriangleSoup& mesh) { meshes_.push_back(mesh); }
  void AddMuscle() { AddPart(MovedBy(Spindle(10, 50, 4), {0, 0, 50})); }
  // From the lower end of the muscle to the foot.
  void AddTendon() { AddPart(MovedBy(Spindle(4, 40, 4), {0, 0, -30})); }

  // Parts with ends; `ends_on` by part, if the scene says it.
  std::vector<SoftPart> Parts(
      const std::vector<std::optional<std::vector<int>>>& ends_on = {}) {
    std::vector<SoftPart> parts;
    for (size_t p = 0; p < meshes_.size(); ++p) {
      const TriangleSoup& mesh = meshes_[p];
      trees_.push_back(
          std::make_unique<TriangleBvh>(mesh.points, mesh.triangles));
      SoftPart part;
      part.surface = trees_.back().get();
      part.volume = SignedVolume(mesh.points, mesh.triangles);
      part.lines = MakeLines("part" + std::to_string(p),
                             mesh,
                             bones_.bodies(),
                             {},
                             /*count=*/1,
                             LinePoints::kNine);
      part.ends = EndsOf({}, FindAttachments(mesh, bones_.bodies(), {}));
      if (p < ends_on.size()) part.ends_on = ends_on[p];
      parts.push_back(std::move(part));
    }
    FindSoftEnds(&parts);
    return parts;
  }

  // A turn about the y axis.
  static Eigen::Matrix3d TurnFromDown(double degrees) {
    return Eigen::AngleAxisd(RadiansOf(degrees), Eigen::Vector3d::UnitY())
        .toRotationMatrix();
  }

  BallBones bones_;
  std::vector<TriangleSoup> meshes_;
  std::vector<std::unique_ptr<TriangleBvh>> trees_;
};

TEST_F(ContinueLinesTest, GoOnThroughATendonToItsBone) {
  AddMuscle();
  AddTendon();
  const std::vector<SoftPart> parts = Parts();
  const ContinuedLines muscle = ContinueLines(0, parts, bones_.bodies());
  EXPECT_THAT(muscle.through, ElementsAre(1));
  ASSERT_EQ(muscle.lines.size(), 1u);
  const ActionLine& line = muscle.lines[0];
  const Points& own = parts[0].lines[0].rest;
  EXPECT_EQ(line.rest.topRows(own.rows()), own);
  EXPECT_LT(line.rest(line.rest.rows() - 1, 2), -60);
  ASSERT_EQ(static_cast<Eigen::Index>(line.bodies.size()), line.rest.rows());
  EXPECT_EQ(line.bodies.front(), "femur");
  EXPECT_EQ(line.bodies.back(), "foot");
  EXPECT_THAT(muscle.tied_to, ElementsAre(1));
  EXPECT_LT(SharpestTurn(line.rest), 0.8);  // rad: no corner between the parts
}

TEST_F(ContinueLinesTest, ATendonHasTheSameWayFromTheOtherEnd) {
  AddMuscle();
  AddTendon();
  const ContinuedLines tendon = ContinueLines(1, Parts(), bones_.bodies());
  EXPECT_THAT(tendon.through, ElementsAre(0));
  EXPECT_THAT(tendon.tied_to, IsEmpty());  // it carries the muscle
  const ActionLine& line = tendon.lines[0];
  const Eigen::Index last = line.rest.rows() - 1;
  const Eigen::Index upper = line.bodies.front() == "femur" ? 0 : last;
  EXPECT_EQ(line.bodies[upper], "femur");
  EXPECT_EQ(line.bodies[last - upper], "foot");
  EXPECT_GT(line.rest(upper, 2), 90);
  EXPECT_LT(line.rest(last - upper, 2), -60);
}

TEST_F(ContinueLinesTest, GoOnThroughSeveralParts) {
  AddMuscle();
  AddPart(MovedBy(Spindle(4, 22, 4), {0, 0, -12}));  // from 10 to -34
  AddPart(MovedBy(Spindle(4, 22, 4), {0, 0, -48}));  // from -26 to -70
  const ContinuedLines muscle = ContinueLines(0, Parts(), bones_.bodies());
  EXPECT_THAT(muscle.through, ElementsAre(1, 2));
  EXPECT_THAT(muscle.tied_to, ElementsAre(1));
  EXPECT_EQ(muscle.lines[0].bodies.back(), "foot");
}

TEST_F(ContinueLinesTest, StayAsTheyAreIfThereIsAGap) {
  AddMuscle();
  AddPart(MovedBy(Spindle(4, 30, 4), {0, 0, -38}));  // 8 mm below
  const std::vector<SoftPart> parts = Parts();
  const ContinuedLines muscle = ContinueLines(0, parts, bones_.bodies());
  EXPECT_THAT(muscle.through, IsEmpty());
  EXPECT_EQ(muscle.lines[0].rest, parts[0].lines[0].rest);
  EXPECT_EQ(muscle.lines[0].bodies, parts[0].lines[0].bodies);
}

TEST_F(ContinueLinesTest, GoOnOverAGapIfTheSceneSaysSo) {
  AddMuscle();
  AddPart(MovedBy(Spindle(4, 30, 4), {0, 0, -38}));
  const std::vector<SoftPart> parts = Parts({std::vector<int>{1}});
  EXPECT_THAT(ContinueLines(0, parts, bones_.bodies()).through, ElementsAre(1));
}

TEST_F(ContinueLinesTest, StayAsTheyAreIfTheSceneSaysThatTheyEnd) {
  AddMuscle();
  AddTendon();
  const std::vector<SoftPart> parts = Parts({std::vector<int>{}, {}});
  EXPECT_THAT(ContinueLines(0, parts, bones_.bodies()).through, IsEmpty());
}

// The other muscle lies beside, from the femur down: its only bone is behind.
TEST_F(ContinueLinesTest, DoNotTurnBack) {
  AddMuscle();
  AddPart(MovedBy(Spindle(6, 52, 4), {6, 0, 49}));
  const std::vector<SoftPart> parts = Parts();
  EXPECT_EQ(parts[0].ends.size(), 2u);
  for (const int part : {0, 1}) {
    EXPECT_THAT(ContinueLines(part, parts, bones_.bodies()).through, IsEmpty());
  }
}

// A tendon that leans by an angle, with a bone at its end; 60 degrees are the
// limit. The lines of a tendon follow its axis to some degrees.
TEST_F(ContinueLinesTest, TurnByUpToSixtyDegrees) {
  const auto goes_on_over_a_turn_of = [&](double degrees) {
    meshes_.clear();
    bones_ = BallBones();
    bones_.Add("femur", {0, 0, 107});
    const Eigen::Vector3d along = TurnFromDown(degrees).col(2);
    bones_.Add("foot", -87 * along.transpose());
    AddMuscle();
    // From 6 mm inside the muscle to 80 mm beyond it.
    TriangleSoup tendon = MovedBy(Spindle(4, 43, 4), {0, 0, -37});
    tendon.points *= TurnFromDown(degrees).transpose();
    AddPart(tendon);
    return !ContinueLines(0, Parts(), bones_.bodies()).through.empty();
  };
  EXPECT_TRUE(goes_on_over_a_turn_of(0));
  EXPECT_TRUE(goes_on_over_a_turn_of(50));
  EXPECT_FALSE(goes_on_over_a_turn_of(68));
}

// Between parts that belong together there may be a gap of 3 mm.
TEST_F(ContinueLinesTest, GoOnOverAGapOfAVoxel) {
  const auto goes_on_over = [&](double gap) {
    meshes_.clear();
    AddMuscle();
    AddPart(MovedBy(Spindle(4, 32, 4), {0, 0, -32 - gap}));
    return !ContinueLines(0, Parts(), bones_.bodies()).through.empty();
  };
  // The tip of the muscle is the centre of its last voxel, up to 2 mm within.
  EXPECT_TRUE(goes_on_over(0.9));
  EXPECT_FALSE(goes_on_over(3.1));
}

TEST_F(ContinueLinesTest, DoNotTurnSharply) {
  AddMuscle();
  TriangleSoup across = Spindle(4, 40, 4);  // along x
  across.points.col(0).swap(across.points.col(2));
  for (auto triangle : across.triangles.rowwise()) {
    std::swap(triangle[0], triangle[1]);
  }
  bones_.Add("fibula", {47, 0, -2});
  AddPart(MovedBy(across, {0, 0, -2}));
  EXPECT_THAT(ContinueLines(0, Parts(), bones_.bodies()).through, IsEmpty());
}

// A thin muscle whose bone is missing lies on one that goes from bone to bone.
TEST_F(ContinueLinesTest, EndOnAThickerPartOnlyIfTheSceneSaysSo) {
  bones_.Add("pelvis", {13, 0, 107});
  AddPart(MovedBy(Spindle(4, 40, 4), {13, 0, 60}));
  AddPart(MovedBy(Spindle(13, 84, 4), {0, 0, 15}));
  EXPECT_THAT(ContinueLines(0, Parts(), bones_.bodies()).through, IsEmpty());
  EXPECT_THAT(
      ContinueLines(0, Parts({std::vector<int>{1}}), bones_.bodies()).through,
      ElementsAre(1));
}

TEST_F(ContinueLinesTest, ComeBackToTheirBodyOnlyIfTheSceneSaysSo) {
  bones_ = BallBones();
  for (const double height : {107.0, -77.0})
    bones_.Add("femur", {0, 0, height});
  AddMuscle();
  AddTendon();
  EXPECT_THAT(ContinueLines(0, Parts(), bones_.bodies()).through, IsEmpty());
  EXPECT_THAT(
      ContinueLines(0, Parts({std::vector<int>{1}}), bones_.bodies()).through,
      ElementsAre(1));
}

TEST(LiesOnSoftPart, CountsHalfOfTheTip) {
  const TriangleSoup ball = Icosphere(20, 3);
  const TriangleBvh tree(ball.points, ball.triangles);
  Points tip(4, 3);
  tip << 0, 0, 0, 0, 0, 20.5, 0, 0, 30, 0, 0, 40;
  EXPECT_TRUE(LiesOnSoftPart(tip, {&tree}));
  tip(1, 2) = 25;
  EXPECT_FALSE(LiesOnSoftPart(tip, {&tree}));
  EXPECT_FALSE(LiesOnSoftPart(tip, {}));
}

// A point that is at most 1 mm away touches, from a plane side of a box.
TEST(LiesOnSoftPart, TouchesWithinAMillimetre) {
  const TriangleSoup box = Box(20, 20, 20);
  const TriangleBvh tree(box.points, box.triangles);
  const auto lies_at = [&](double distance) {
    return LiesOnSoftPart(Points(Eigen::RowVector3d(0, 0, 10 + distance)),
                          {&tree});
  };
  EXPECT_TRUE(lies_at(0.95));
  EXPECT_FALSE(lies_at(1.05));
}

// Two of four points are half of them, two of five are not.
TEST(LiesOnSoftPart, AsksForHalfOfThePoints) {
  const TriangleSoup box = Box(20, 20, 20);
  const TriangleBvh tree(box.points, box.triangles);
  Points tip = Points::Zero(5, 3);
  tip.col(2) << 0, 0, 30, 30, 30;
  EXPECT_TRUE(LiesOnSoftPart(tip.topRows(4), {&tree}));
  EXPECT_FALSE(LiesOnSoftPart(tip, {&tree}));
  EXPECT_FALSE(LiesOnSoftPart(tip.bottomRows(1), {&tree}));
}

// Attachments that the scene names are enough if there are two.
TEST(EndsOf, AreThoseOfTheSceneAndThenThoseThatWereFound) {
  Attachment named;
  named.body = "pelvis";
  named.points = Eigen::RowVector3d(1, 2, 3);
  FoundAttachment found;
  found.attachment.body = "femur";
  found.attachment.points = Eigen::RowVector3d(4, 5, 6);
  found.is_on_bones = false;
  found.tip << 7, 8, 9;
  SceneMuscle muscle;
  muscle.attachments = {named, named};
  EXPECT_EQ(EndsOf(muscle, {found}).size(), 2u);
  muscle.attachments = {named};
  const std::vector<SoftPartEnd> ends = EndsOf(muscle, {found});
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].body, "pelvis");
  EXPECT_TRUE(ends[0].is_on_bones);
  EXPECT_EQ(ends[1].Middle(), Eigen::RowVector3d(4, 5, 6));
  EXPECT_FALSE(ends[1].is_on_bones);
  EXPECT_EQ(ends[1].tip, Eigen::RowVector3d(7, 8, 9));
}

}  // namespace
}  // namespace musclewarp
