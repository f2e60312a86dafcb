// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// Takes back the last step of the vertices of either body that it has carried
// into the other (paper section 3.3): they go back along their step to the
// surface, or deformable_share of that way if both can move. A vertex that
// finds no way out within the longest steps of the two bodies (it was inside
// before, and deeper) goes back to where it was.
//
// `before_a`, `before_b`: the points before the step; those of an obstacle are
// not used. `found_a`, `found_b` (#V): set to true for the vertices that were
// inside, others are left.
void RollBackStep(const PaperContactOptions& options,
                  const Points& before_a,
                  const Points& before_b,
                  ContactBody* a,
                  ContactBody* b,
                  std::vector<char>* found_a,
                  std::vector<char>* found_b);

}  // namespace musclewarp
