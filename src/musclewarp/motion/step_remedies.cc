// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/step_remedies.h"

#include <map>

namespace musclewarp {

const std::vector<StepRemedy>& RemediesOf(StepOutcome outcome) {
  using Outcome = StepOutcome;
  using Remedy = StepRemedy;
  static const std::map<Outcome, std::vector<Remedy>> kRemedies = {
      {Outcome::kClean, {Remedy::kAccept}},
      {Outcome::kPushedFar, {Remedy::kShorten}},
      {Outcome::kPassing, {Remedy::kHalve}},
      {Outcome::kNotFinite, {Remedy::kHalve, Remedy::kGoBack, Remedy::kGiveUp}},
      {Outcome::kCrossing,
       {Remedy::kHalve,
        Remedy::kGoBack,
        Remedy::kReachFarther,
        Remedy::kAcceptStuck}},
      {Outcome::kStillStuck, {Remedy::kAcceptStuck}},
      {Outcome::kSettledClean, {Remedy::kSettle}},
      {Outcome::kSettledCrossing,
       {Remedy::kReachFarther, Remedy::kEndSettling}},
      {Outcome::kSettledNotFinite, {Remedy::kEndSettling}}};
  return kRemedies.at(outcome);
}

}  // namespace musclewarp
