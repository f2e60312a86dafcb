// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// What came of a step of certified contact that was tried.
enum class StepOutcome {
  kClean,      // nothing crosses
  kPushedFar,  // it was given up, as contact pushes muscles too far

  // Triangles cross that did not before. A stuck scene is one in which they
  // still do: nothing more is tried until they have parted.
  kCrossing,
  kStillStuck,

  // The same of a step at the pose itself.
  kSettledClean,
  kSettledCrossing,
};

// What can follow.
enum class StepRemedy {
  kAccept,        // go on from where the step ended
  kAcceptStuck,   // the same, and remember the last place without crossings
  kShorten,       // try a shorter step, as much as the push asks for
  kHalve,         // try a step of half the length
  kGoBack,        // go a few steps back, for shorter ones all the way
  kReachFarther,  // try the step with more reach
  kSettle,        // accept a step at the pose, and see what has settled
  kEndSettling,   // leave the scene as it was before the step
};

// Returns what follows an outcome: the first of these that is possible. The
// last one always is.
const std::vector<StepRemedy>& RemediesOf(StepOutcome outcome);

}  // namespace musclewarp
