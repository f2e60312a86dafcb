// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// Removes the small overlap of two bodies that is left after the iterations,
// when no step shows the way back any more and the closest point of the surface
// is the right one. Beyond the paper, which leaves that overlap.
//
// - A vertex of either body inside the other is put on the closest point of the
//   other's surface, or deformable_fraction of that way if both are muscles,
//   and the clearance beyond.
// - A vertex of an obstacle inside a muscle cannot move. The triangle of the
//   muscle that it came through is pushed off it instead, unless that is
//   farther than pairing_fraction of the muscle's bounding radius.
//
// Both bodies are tested before either moves. One call reduces the overlap but
// need not remove it; GroupContact::Finish calls it in rounds.
// Precondition: `a` is deformable. Returns true if anything was inside.
bool PushOut(const PaperContactOptions& options,
             ContactBody* a,
             ContactBody* b);

}  // namespace musclewarp
