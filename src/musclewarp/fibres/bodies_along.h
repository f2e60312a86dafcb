// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the body that guides each point of a line (#P x 3, mm, at rest), #P:
// first `origin`, then optionally one intermediate body, then `insertion`. The
// sum of the distances between points and their bodies is minimal.
std::vector<std::string> BodiesAlong(const Points& line,
                                     const std::string& origin,
                                     const std::string& insertion,
                                     const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
