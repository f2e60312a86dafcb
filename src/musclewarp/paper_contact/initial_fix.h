// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// Removes the overlap that two bodies have before the first iteration, when
// there is no step to take back (paper section 3.2). The vertices of either
// body inside the other are grouped into connected regions, and the regions of
// the two bodies are paired (regions.h).
//
// - Paired regions move along the line of their centres, all vertices in
//   parallel so that triangles do not fold: all the way to the surface of an
//   obstacle, deformable_fraction of it if both bodies are muscles.
// - An unpaired region of a muscle moves against the mean of its normals, all
//   the way.
// - Obstacles stay; unpaired regions of theirs are left.
//
// All ways are measured before either body moves. Returns true if anything was
// inside.
bool FixInitialIntersections(const PaperContactOptions& options,
                             ContactBody* a,
                             ContactBody* b);

}  // namespace musclewarp
