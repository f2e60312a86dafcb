// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Finds where a muscle is attached, which meshes from segmentation do not say:
// at each of its two ends (FindMuscleEnds) the largest connected part of the
// surface that lies on the bones of the end's body, or in them. If the bone of
// an end is not in the scene, its tip is attached to the nearest body, unless
// it lies on another soft part, as a muscle does that ends in a tendon of its
// own mesh: to what that is attached is not known here.
//
// All meshes and `lines`, the action lines of the muscle, are those of the rest
// pose, in mm. The points of an attachment are
// vertices of `muscle`, and its radius is next to nothing, so that it covers
// just these. Of areas that run along the muscle they have `extent`. There may
// be two attachments, one, or none.
std::vector<Attachment> FindAttachments(
    const TriangleSoup& muscle,
    const std::vector<BodySurface>& bodies,
    const std::vector<const TriangleBvh*>& soft_parts,
    const std::vector<ActionLine>& lines,
    EndExtent extent = EndExtent::kFarPart);

}  // namespace musclewarp
