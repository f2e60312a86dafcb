// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// Returns the parts of the lines of a muscle that stand for tendons without a
// mesh (ActionLine::bare_begin, bare_end) in a pose, or at rest without one:
// from the mesh to the bone, or from the bone to the mesh; #P x 3 each, mm,
// with as many points in each pose.
std::vector<Points> BareTendonLines(const std::vector<ActionLine>& lines,
                                    const ScenePose* pose);

}  // namespace musclewarp
