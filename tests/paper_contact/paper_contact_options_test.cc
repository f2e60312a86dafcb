// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/paper_contact_options.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/invalid_options.h"

namespace musclewarp {

TEST(PaperContactOptions, DefaultsAndLimitsAreValid) {
  PaperContactOptions options;
  ExpectValid(options);
  options.deformable_fraction = 0.5;
  options.pairing_fraction = 0;
  options.clearance = 0;
  ExpectValid(options);
  options.deformable_fraction = 1;
  ExpectValid(options);
}

TEST(PaperContactOptions, RefuseValuesOutOfRange) {
  // Two muscles that go less than half of the way each stay inside each other.
  ExpectRefused<PaperContactOptions>(
      [](auto* options) { options->deformable_fraction = 0.4; },
      "PaperContactOptions::deformable_fraction is 0.4, allowed: 0.5 to 1");
  ExpectRefused<PaperContactOptions>(
      [](auto* options) { options->deformable_fraction = 1.5; },
      "PaperContactOptions::deformable_fraction is 1.5, allowed: 0.5 to 1");
  ExpectRefused<PaperContactOptions>(
      [](auto* options) { options->pairing_fraction = -0.1; },
      "PaperContactOptions::pairing_fraction is -0.1, allowed: 0 or above");
  ExpectRefused<PaperContactOptions>(
      [](auto* options) { options->clearance = NAN; },
      "PaperContactOptions::clearance is nan, allowed: 0 or above");
}

}  // namespace musclewarp
