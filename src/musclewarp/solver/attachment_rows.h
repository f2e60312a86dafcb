// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The fine vertices (of `points`, #V x 3) within the radius of an attachment,
// thinned evenly to at most `max_rows`, in rising order.
std::vector<int> AttachedVertices(const Attachment& attachment,
                                  const Points& points,
                                  int max_rows);

}  // namespace musclewarp
