// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The vertices (of `points`, #V x 3, rest pose) within the radius of an
// attachment, rising.
std::vector<int> VerticesInArea(const Attachment& attachment,
                                const Points& points);

}  // namespace musclewarp
