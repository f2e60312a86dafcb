// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The fine vertices of a muscle that follow bodies, because they lie in its
// attachment areas. Where areas overlap, the first one counts.
struct AttachedVertices {
  std::vector<int> vertices;    // in rising order
  std::vector<int> attachment;  // of each: its number
};

// Returns the vertices among `rest` (#V x 3, rest pose, mm) that the
// attachments cover.
AttachedVertices FindAttachedVertices(
    const std::vector<Attachment>& attachments, const Points& rest);

// Returns the area of each attachment on the surface, mm^2: a third of every
// triangle for each of its corners that is attached. `points`: #V x 3, mm.
std::vector<double> AttachedAreas(const std::vector<Attachment>& attachments,
                                  const AttachedVertices& attached,
                                  const Points& points,
                                  const Triangles& triangles);

// Returns where the bodies have the attached vertices in a pose, #attached x 3,
// mm. `rest`: where they have them in the rest pose.
Points AttachedPositions(const std::vector<Attachment>& attachments,
                         const AttachedVertices& attached,
                         const Points& rest,
                         const ScenePose& pose);

// How far an attachment area has left the place at which its body has it.
struct AttachmentDrift {
  std::string body;
  int vertices = 0;
  double mean = 0, max = 0;  // of the distances of its vertices, mm
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  // of the farthest one
};

// An attachment that leaves its body by more than this, mm, is beyond anatomy.
constexpr double kLargestDrift = 2;

// Returns the drift of each attachment. `points`: the fine mesh, #V x 3, mm;
// `positions`: where the bodies have the attached vertices, #attached x 3, mm.
std::vector<AttachmentDrift> DriftOf(const std::vector<Attachment>& attachments,
                                     const AttachedVertices& attached,
                                     const Points& positions,
                                     const Points& points);

}  // namespace musclewarp
