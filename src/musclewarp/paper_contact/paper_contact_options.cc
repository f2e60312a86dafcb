// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/paper_contact_options.h"

#include "musclewarp/base/invalid_option.h"

namespace musclewarp {

bool PaperContactOptions::IsValid(std::string* error) const {
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption(
        "PaperContactOptions::" + field, value, allowed, error);
  };
  if (!(0.5 <= deformable_fraction && deformable_fraction <= 1)) {
    return fail("deformable_fraction", deformable_fraction, "0.5 to 1");
  }
  if (!(pairing_fraction >= 0)) {
    return fail("pairing_fraction", pairing_fraction, "0 or above");
  }
  if (!(clearance >= 0)) return fail("clearance", clearance, "0 or above");
  return true;
}

}  // namespace musclewarp
