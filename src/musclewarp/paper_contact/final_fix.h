// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// Puts the vertices of either body that lie inside the other on the closest
// point of its surface, or deformable_share of that way if both can move.
// Vertices of an obstacle inside a muscle push the triangle in front of them
// instead. For what little the iterations leave, where no step shows the way
// back and the closest point is the right one. `a` is deformable. True if there
// was anything inside.
bool PushOut(const PaperContactOptions& options,
             ContactBody* a,
             ContactBody* b);

}  // namespace musclewarp
