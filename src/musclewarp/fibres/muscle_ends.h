// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The bones of a body, in the rest pose.
struct BodySurface {
  std::string body;
  std::vector<const TriangleBvh*> bones;

  double Distance(const Eigen::RowVector3d& point) const;  // mm
};

// An end of a muscle: part of its inside, and the body it is attached to ("" if
// there are no bones).
struct MuscleEnd {
  std::string body;
  std::vector<int> voxels;  // rising
};

struct MuscleEnds {
  MuscleEnd origin, insertion;
};

// Where a muscle begins and ends. With attachments: the areas of the two that
// are farthest apart. Without: where it lies near its bones, at the two places
// that are farthest apart by the way through the muscle; an end of the muscle
// far from all of these places, whose bone is not in the scene, say, counts as
// one of them and goes to the body next to it. Of areas that run along the
// muscle only the ends are kept; where that leaves no two, the tips of the
// muscle. The origin is the end whose body comes first in `bodies`.
// Precondition: the grid has two voxels.
MuscleEnds FindMuscleEnds(const TriangleSoup& muscle,
                          const VoxelGrid& grid,
                          const std::vector<BodySurface>& bodies,
                          const std::vector<Attachment>& attachments);

}  // namespace musclewarp
