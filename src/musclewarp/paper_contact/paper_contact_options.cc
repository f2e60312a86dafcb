// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

bool PaperContactOptions::IsValid(std::string* error) const {
  const auto fail = [error](const std::string& rule) {
    *error = "PaperContactOptions: " + rule;
    return false;
  };
  if (!(0.5 <= deformable_share && deformable_share <= 1)) {
    return fail("allowed: 0.5 <= deformable_share <= 1");
  }
  if (!(pairing_share >= 0)) return fail("pairing_share must not be negative");
  if (!(clearance >= 0)) return fail("clearance must not be negative");
  return true;
}

}  // namespace musclewarp
