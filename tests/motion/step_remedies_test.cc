// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/step_remedies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

using Outcome = StepOutcome;
using Remedy = StepRemedy;

TEST(StepRemedies, WhatIsCleanIsAccepted) {
  EXPECT_THAT(RemediesOf(Outcome::kClean), ElementsAre(Remedy::kAccept));
  EXPECT_THAT(RemediesOf(Outcome::kSettledClean), ElementsAre(Remedy::kSettle));
}

TEST(StepRemedies, WhatPushesMusclesFarIsShortened) {
  EXPECT_THAT(RemediesOf(Outcome::kPushedFar), ElementsAre(Remedy::kShorten));
}

TEST(StepRemedies, WhatPassesThroughABoneIsHalved) {
  EXPECT_THAT(RemediesOf(Outcome::kPassing), ElementsAre(Remedy::kHalve));
}

TEST(StepRemedies, WhatIsNotFiniteIsNeverTaken) {
  EXPECT_THAT(RemediesOf(Outcome::kNotFinite),
              ElementsAre(Remedy::kHalve, Remedy::kGoBack, Remedy::kGiveUp));
  EXPECT_THAT(RemediesOf(Outcome::kSettledNotFinite),
              ElementsAre(Remedy::kEndSettling));
}

// Shorter steps come first, as they lose nothing. More reach lets muscles move
// farther than need be.
TEST(StepRemedies, WhatCrossesIsTakenOnlyIfNothingElseIsLeft) {
  EXPECT_THAT(RemediesOf(Outcome::kCrossing),
              ElementsAre(Remedy::kHalve,
                          Remedy::kGoBack,
                          Remedy::kReachFarther,
                          Remedy::kAcceptStuck));
  EXPECT_THAT(RemediesOf(Outcome::kStillStuck),
              ElementsAre(Remedy::kAcceptStuck));
}

TEST(StepRemedies, WhatCrossesAtThePoseIsNeverTaken) {
  EXPECT_THAT(RemediesOf(Outcome::kSettledCrossing),
              ElementsAre(Remedy::kReachFarther, Remedy::kEndSettling));
}

}  // namespace
}  // namespace musclewarp
