// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns which bodies guide the points of a line (#P x 3, mm, at rest), #P:
// first `origin`, then perhaps one between, then `insertion`. The sum of the
// distances of the points from their bodies is as small as it can be.
std::vector<std::string> BodiesAlong(const Points& line,
                                     const std::string& origin,
                                     const std::string& insertion,
                                     const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
