// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// A muscle may be attached to a bone that is not farther away than this, mm.
constexpr double kNearBone = 10;

// The area of an attachment is what is farther from the bone than the nearest
// point of the muscle by at most this, mm.
constexpr double kAreaDepth = 3;

// The surface of a body in the rest pose: that of all bones that move with it.
struct BodySurface {
  std::string body;                       // its name
  std::vector<const TriangleBvh*> bones;  // must outlive this object

  // Returns the distance (mm) from a point to the nearest bone, or infinity if
  // there are no bones.
  double Distance(const Eigen::RowVector3d& point) const;
};

// Returns for each body the points (#V x 3, mm, at rest) of a muscle that lie
// on it: nearer to its bones than to those of other bodies, and at most
// kAreaDepth farther from them than the nearest point, if that is within
// kNearBone.
std::vector<std::vector<int>> VerticesNearBones(
    const Points& points, const std::vector<BodySurface>& bodies);

// One end of a muscle: the part of its inside that belongs to it, and the body
// to which it is attached.
struct MuscleEnd {
  std::string body;         // empty if there are no bones
  std::vector<int> voxels;  // ascending
};

// Both ends of a muscle.
struct MuscleEnds {
  MuscleEnd origin, insertion;
};

// What a scene says about the ends of a muscle. Either may be empty.
struct KnownEnds {
  std::vector<Attachment> attachments;
  std::vector<ActionLine> lines;
};

// How much of an area that was found, and runs along the muscle, is its end.
enum class EndExtent {
  // What is far from the other end. Where more is held than is attached, a
  // tendon beside a bone for example, what is left between has to bear all of
  // the stretch.
  kFarPart,
  // What is far from the other end, or from the bones of its body: where fibres
  // may begin.
  kClearOfOther,
};

// Finds where a muscle begins and ends, which meshes from segmentation do not
// say. `grid` holds the voxels of the mesh `muscle`, in the rest pose.
//
// If there are attachments, the ends are the areas of the two that are farthest
// apart. Otherwise they are two areas in which the muscle lies near its bones,
// again those farthest apart by the way through the muscle. A tip of the muscle
// that is far from all of these areas, for example because its bone is not in
// the scene, counts as such an area and belongs to the nearest body. So does a
// tip at which one of the action lines ends; it belongs to the line's body.
//
// Areas that are given count whole, those of one body together; those that are
// found have the given extent. If no two
// ends remain, the two tips of the muscle are the ends. The origin is the end
// whose body comes first in `bodies`. Precondition: the grid has at least two
// voxels.
MuscleEnds FindMuscleEnds(const TriangleSoup& muscle,
                          const VoxelGrid& grid,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& known,
                          EndExtent extent);

}  // namespace musclewarp
