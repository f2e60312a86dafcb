// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// The outcome of an attempted step of certified contact.
enum class StepOutcome {
  kClean,      // no triangles cross
  kPushedFar,  // rejected, as contact pushes muscles too far
  kPassing,    // rejected, as a muscle would pass through a bone
  kNotFinite,  // rejected, as it comes to coordinates that are not finite

  // Triangles start to cross, or still cross since an earlier accepted step. In
  // the latter case no remedy is tried until they are separated.
  kCrossing,
  kStillStuck,

  // The outcomes of a settling step.
  kSettledClean,
  kSettledCrossing,
  kSettledNotFinite,
};

// The responses of the stepper to an outcome.
enum class StepRemedy {
  kAccept,        // accept the step
  kAcceptStuck,   // accept it, and keep the last state without crossings
  kShorten,       // retry with a length reduced according to the push
  kHalve,         // retry with half the length
  kGoBack,        // backtrack a few steps and continue with shorter ones
  kReachFarther,  // retry with a larger reach
  kSettle,        // accept a settling step and test for convergence
  kEndSettling,   // reject the settling step and stop
  kGiveUp,        // reject the step; the remainder is computed without contact
};

// Returns the remedies of an outcome in order of preference. The stepper
// applies the first available one; the last one always is.
const std::vector<StepRemedy>& RemediesOf(StepOutcome outcome);

}  // namespace musclewarp
