// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// An attachment radius that covers only the attachment's own points, mm.
constexpr double kPointsAlone = 1e-6;

// Returns an attachment that covers the area within the outline of the given
// one. Its points are the vertices of the muscle that are at most
// attachment.radius away from the points of the outline, and those inside the
// outline that are at most this distance from the bones of the body; its radius
// is kPointsAlone. The points of the outline must be in order; vertices are
// inside if the outline encloses them as seen along its mean normal, in either
// direction of rotation where it crosses itself. Vertices farther from the
// plane of the outline than the radius of a circle of the same area are not
// inside. If there are no such vertices, the attachment is returned unchanged.
// Positions are in mm, in the rest pose.
Attachment FilledOutline(const Attachment& attachment,
                         const TriangleSoup& muscle,
                         const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
