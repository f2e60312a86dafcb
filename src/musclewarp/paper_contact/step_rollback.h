// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// Takes back the last step of those vertices of two bodies that it carried into
// the other body (paper section 3.3). Such a vertex goes back along its step to
// the surface of the other body, or deformable_fraction of that way if both are
// muscles, and the clearance beyond.
//
// The surface is looked for no farther than the longest steps of the two bodies
// together. A vertex that finds none within that distance was inside before the
// step, and deeper; it returns to where it was.
//
// - `before_a`, `before_b` are the points before the step, #V x 3, mm. Those of
//   an obstacle are not used and may be empty.
// - `found_a`, `found_b` (#V) are set to true for the vertices that were
//   inside; other entries are left as they are. That of an obstacle is not used
//   and may be null.
//
// Both bodies are tested before either moves. Obstacles stay.
void RollBackStep(const PaperContactOptions& options,
                  const Points& before_a,
                  const Points& before_b,
                  ContactBody* a,
                  ContactBody* b,
                  std::vector<char>* found_a,
                  std::vector<char>* found_b);

}  // namespace musclewarp
