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

// The largest distance between a muscle and a bone to which it is attached, mm.
constexpr double kNearBone = 10;

// Surface points whose distance to the bone exceeds the smallest such distance
// by at most this belong to the attachment, mm.
constexpr double kAreaDepth = 3;

// The surface of a body in the rest pose: the surfaces of all its bones.
struct BodySurface {
  std::string body;
  std::vector<const TriangleBvh*> bones;  // must outlive this object

  // Returns the distance (mm) from a point to the nearest bone, or infinity if
  // there are no bones.
  double Distance(const Eigen::RowVector3d& point) const;
};

// Returns, for each body, the indices of the points (#V x 3, mm, at rest) of a
// muscle that lie on it: the points that are nearer to its bones than to those
// of other bodies, and at most kAreaDepth farther from them than the nearest
// point is. No point lies on a body whose nearest point is more than kNearBone
// away.
std::vector<std::vector<int>> VerticesNearBones(
    const Points& points, const std::vector<BodySurface>& bodies);

// One end of a muscle: its voxels, and the body to which it is attached.
struct MuscleEnd {
  std::string body;         // empty if there are no bones
  std::vector<int> voxels;  // ascending
};

// Both ends of a muscle.
struct MuscleEnds {
  MuscleEnd origin, insertion;
};

// The data of a scene about the ends of a muscle. Either may be empty.
struct KnownEnds {
  std::vector<Attachment> attachments;
  std::vector<ActionLine> lines;
};

// The part of a detected area along a muscle that is its end.
enum class EndExtent {
  // The part far from the other end. If more than the true attachment is held,
  // for example a tendon next to a bone, the rest of the muscle has to take up
  // all of the stretch.
  kFarPart,
  // The part far from the other end, or far from the bones of the other end's
  // body: fibres may begin there.
  kClearOfOther,
};

// Finds the two ends of a muscle, which segmented meshes do not contain. `grid`
// has the voxels of the mesh `muscle`, in the rest pose.
//
// If there are attachments, the ends are the areas of the two that are farthest
// apart, measured through the muscle. Otherwise the ends are the two areas
// farthest apart in which the muscle lies near bones. A tip of the muscle that
// is far from all of these areas, for example because its bone is not in the
// scene, is such an area too and belongs to the nearest body. So is a tip at
// which one of the action lines ends; it belongs to the line's body.
//
// Given attachments are used completely, with those of one body merged;
// `extent` limits detected areas. If no two ends remain, the two tips of the
// muscle are the ends. The origin is the end whose body comes first in
// `bodies`. Precondition: the grid has at least two voxels.
MuscleEnds FindMuscleEnds(const TriangleSoup& muscle,
                          const VoxelGrid& grid,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& known,
                          EndExtent extent);

}  // namespace musclewarp
