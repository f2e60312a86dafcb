// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Selects the fine vertices that attachment rows tie to a body. Attachment rows
// go beyond the paper: they make the area where a muscle is attached follow its
// bone (docs/method.md).
//
// Returns the indices, in rising order, of the vertices in `points` (#V x 3,
// rest pose, mm) that lie within the radius of `attachment`. If there are more
// than `max_rows` of them, every so-many-th is kept, so that exactly `max_rows`
// remain: each row is dense, and more rows would cost time without changing the
// shape. Precondition: max_rows is above 0.
std::vector<int> VerticesWithRows(const Attachment& attachment,
                                  const Points& points,
                                  int max_rows);

}  // namespace musclewarp
