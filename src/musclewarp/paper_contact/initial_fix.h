// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// Drags the vertices of either body that lie inside the other out of it, by
// regions (paper section 3.2). Paired regions move along the line of their
// centres, all vertices the same way, so that triangles do not fold: all the
// way to an obstacle's surface, deformable_share of it if both can move. An
// unpaired region moves against the mean of its normals, all the way. Obstacles
// stay. True if there was anything inside.
bool FixInitialIntersections(const PaperContactOptions& options,
                             ContactBody* a,
                             ContactBody* b);

}  // namespace musclewarp
