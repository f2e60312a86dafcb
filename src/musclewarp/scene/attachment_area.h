// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns the vertices of a muscle that an attachment covers: the indices of
// the rows of `points` (#V x 3, mm, rest pose) that are at most
// attachment.radius away from one of its points, in ascending order.
std::vector<int> VerticesInArea(const Attachment& attachment,
                                const Points& points);

}  // namespace musclewarp
