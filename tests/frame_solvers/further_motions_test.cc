// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/further_motions.h"

#include <gtest/gtest.h>

#include <vector>

namespace musclewarp {
namespace {

constexpr double kGap = 0.2;  // mm

// A move of two steps, 10 ms and 1 ms, after which two muscles are so far apart
// (mm).
CertifiedMove MoveTo(double apart) {
  CertifiedMove move;
  move.motion.summary.steps = 2;
  move.moving_ms = 10;
  move.certifying_ms = 1;
  MeshGap gap;
  gap.at_least_mm = apart;
  gap.at_most_mm = apart;
  move.frame.intersections.gaps = {gap};
  return move;
}

// A move after which contact has moved a muscle by so much (mm) more than
// allowed.
CertifiedMove ExcessiveMoveTo(double apart, double excess) {
  CertifiedMove move = MoveTo(apart);
  MuscleFrame& muscle = move.frame.muscles.emplace_back();
  muscle.max_contact_displacement =
      AllowedDisplacement(FrameRequirements(), muscle) + excess;
  return move;
}

CertifiedMove CrossingMoveTo(double apart) {
  CertifiedMove move = MoveTo(apart);
  move.frame.intersections.triangle_pairs = 1;
  return move;
}

// What came of moves that were made one after the other.
struct Outcome {
  CertifiedMove move;
  int made = 0;
  std::vector<Settling> settlings;

  double Apart() const { return move.frame.intersections.gaps[0].at_least_mm; }
};

// Each move begins where the one before ended; what there is withheld counts
// them.
Outcome MovedBy(std::vector<CertifiedMove> moves) {
  Outcome outcome;
  ContactState start;
  start.withheld = {0};
  outcome.move = MoveUntilSound(
      [&](const ContactState& from, Settling settling) {
        EXPECT_EQ(from.withheld[0], outcome.made);
        outcome.settlings.push_back(settling);
        CertifiedMove& move = moves.at(outcome.made++);
        move.motion.state.withheld = {static_cast<double>(outcome.made)};
        return move;
      },
      start,
      kGap,
      FrameRequirements());
  return outcome;
}

TEST(MoveUntilSound, MovesOnceIfTheGapIsKept) {
  EXPECT_EQ(MovedBy({MoveTo(kGap)}).made, 1);
  CertifiedMove free = MoveTo(kGap);
  free.frame.intersections.gaps.clear();
  EXPECT_EQ(MovedBy({free}).made, 1);
}

TEST(MoveUntilSound, MovesAgainUntilTheGapIsKept) {
  const Outcome outcome = MovedBy({MoveTo(0.19), MoveTo(0.21), MoveTo(0.3)});
  EXPECT_EQ(outcome.made, 2);
  EXPECT_EQ(outcome.Apart(), 0.21);
  EXPECT_EQ(outcome.move.motion.state.withheld[0], 2);
  EXPECT_EQ(outcome.move.motion.summary.steps, 4);
  EXPECT_EQ(outcome.move.moving_ms, 20);
  EXPECT_EQ(outcome.move.certifying_ms, 2);
}

TEST(MoveUntilSound, MovesAtMostTwiceMore) {
  const Outcome outcome =
      MovedBy({MoveTo(0.1), MoveTo(0.12), MoveTo(0.14), MoveTo(0.3)});
  EXPECT_EQ(outcome.made, 3);
  EXPECT_EQ(outcome.Apart(), 0.14);
  EXPECT_EQ(outcome.move.motion.summary.steps, 6);
}

TEST(MoveUntilSound, StaysWhereItWasIfMovingOnDoesNotHelp) {
  for (const double next : {0.1, 0.09}) {
    const Outcome outcome = MovedBy({MoveTo(0.1), MoveTo(next)});
    EXPECT_EQ(outcome.made, 2);
    EXPECT_EQ(outcome.move.motion.state.withheld[0], 1);
    EXPECT_EQ(outcome.move.motion.summary.steps, 2);
  }
}

// However wide the gaps of all other meshes are then.
TEST(MoveUntilSound, TakesNoFurtherMotionThatCrosses) {
  const Outcome crossing = MovedBy({MoveTo(0.1), CrossingMoveTo(0.3)});
  EXPECT_EQ(crossing.made, 2);
  EXPECT_EQ(crossing.Apart(), 0.1);
  CertifiedMove given_up = MoveTo(0.3);
  given_up.motion.last_clean = ContactState();
  EXPECT_EQ(MovedBy({MoveTo(0.1), given_up}).Apart(), 0.1);
}

TEST(MoveUntilSound, DoesNotMoveOnAcrossAMesh) {
  EXPECT_EQ(MovedBy({CrossingMoveTo(0.1)}).made, 1);
}

// Attachments may be inside their bones: that gap is none.
TEST(MoveUntilSound, DoesNotAskForAGapOfWhatMayPenetrate) {
  CertifiedMove move = MoveTo(0.3);
  move.frame.intersections.gaps.emplace_back();
  EXPECT_EQ(MovedBy({move}).made, 1);
}

TEST(MoveUntilSound, SettlesFullyWhatIsMovedTooFar) {
  const Outcome outcome = MovedBy({ExcessiveMoveTo(kGap, 3),
                                   ExcessiveMoveTo(kGap, 1),
                                   ExcessiveMoveTo(kGap, -1)});
  EXPECT_EQ(outcome.made, 3);
  EXPECT_EQ(outcome.settlings,
            (std::vector<Settling>{
                Settling::kIfPushed, Settling::kFully, Settling::kFully}));
  EXPECT_EQ(outcome.move.motion.summary.steps, 6);
}

TEST(MoveUntilSound, DoesNotSettleWhatIsMovedLittle) {
  EXPECT_EQ(MovedBy({ExcessiveMoveTo(kGap, 0)}).made, 1);
}

// Neither for nothing nor at the price of the gap.
TEST(MoveUntilSound, StaysWhereItWasIfSettlingDoesNotHelp) {
  for (const CertifiedMove& next :
       {ExcessiveMoveTo(kGap, 3), ExcessiveMoveTo(0.1, 1)}) {
    const Outcome outcome = MovedBy({ExcessiveMoveTo(kGap, 3), next});
    EXPECT_EQ(outcome.made, 2);
    EXPECT_EQ(outcome.move.motion.state.withheld[0], 1);
  }
}

}  // namespace
}  // namespace musclewarp
