// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// An attachment that was detected on the meshes.
struct FoundAttachment {
  Attachment attachment;

  // False at an end without a bone: the attachment then covers the tip of the
  // muscle and follows the nearest body.
  bool is_on_bones = true;

  // At an end without a bone: the point farthest from the other end of the
  // muscle, mm.
  Eigen::RowVector3d tip = Eigen::RowVector3d::Zero();
};

// Finds the attachments of a muscle, which segmented meshes do not contain: at
// each of its two ends (FindMuscleEnds), the largest connected part of the
// surface that lies on or inside the bones of the end's body. If the bone of an
// end is not in the scene, the tip of the muscle is attached to the nearest
// body.
//
// All meshes and `lines`, the action lines of the muscle, are in the rest pose,
// in mm. The points of an attachment are vertices of `muscle`, and its radius
// is kPointsAlone, so that it covers only these. `extent` limits areas that run
// along the muscle. Returns two attachments, one, or none.
std::vector<FoundAttachment> FindAttachments(
    const TriangleSoup& muscle,
    const std::vector<BodySurface>& bodies,
    const std::vector<ActionLine>& lines,
    EndExtent extent = EndExtent::kFarPart);

}  // namespace musclewarp
