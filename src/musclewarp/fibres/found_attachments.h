// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// An attachment that was found on the meshes.
struct FoundAttachment {
  Attachment attachment;

  // False at an end without a bone: the attachment is then the tip of the
  // muscle, on the nearest body.
  bool is_on_bones = true;

  // Where the tip is farthest from the other end of the muscle, mm.
  Eigen::RowVector3d tip = Eigen::RowVector3d::Zero();
};

// Finds where a muscle is attached, which meshes from segmentation do not say:
// at each of its two ends (FindMuscleEnds) the largest connected part of the
// surface that lies on the bones of the end's body, or in them. If the bone of
// an end is not in the scene, its tip is attached to the nearest body.
//
// All meshes and `lines`, the action lines of the muscle, are those of the rest
// pose, in mm. The points of an attachment are vertices of `muscle`, and its
// radius is next to nothing, so that it covers just these. Of areas that run
// along the muscle they have `extent`. There may be two attachments, one, or
// none.
std::vector<FoundAttachment> FindAttachments(
    const TriangleSoup& muscle,
    const std::vector<BodySurface>& bodies,
    const std::vector<ActionLine>& lines,
    EndExtent extent = EndExtent::kFarPart);

}  // namespace musclewarp
