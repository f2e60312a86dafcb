// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A radius that covers the points of an attachment themselves, mm.
constexpr double kPointsAlone = 1e-6;

// Returns an attachment whose points go round its area as one that has the area
// itself: its points are the vertices of the muscle, within kPointsAlone, that
// are at most attachment.radius away from the outline, and those inside of it
// that are at most so far away from the bones of the body. Inside is told along
// the mean normal of the outline, for which its points are in order. Where it
// crosses itself, what it goes round counts; what lies as far from its plane as
// it is wide does not. If there are no such vertices, the attachment is
// returned as it is.
Attachment FilledOutline(const Attachment& attachment,
                         const TriangleSoup& muscle,
                         const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
