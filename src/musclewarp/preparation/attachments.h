// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/shape_figures.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// The fine vertices of a muscle within its attachment areas, which move with
// bodies. Where areas overlap, the first one applies.
struct AttachedVertices {
  std::vector<int> vertices;    // ascending
  std::vector<int> attachment;  // index of the attachment of each
};

// Returns the vertices of `rest` (#V x 3, rest pose, mm) within the
// attachments.
AttachedVertices FindAttachedVertices(
    const std::vector<Attachment>& attachments, const Points& rest);

// Returns the surface area of each attachment, mm^2: a third of the area of a
// triangle per attached corner. `points`: #V x 3, mm.
std::vector<double> AttachedAreas(const std::vector<Attachment>& attachments,
                                  const AttachedVertices& attached,
                                  const Points& points,
                                  const Triangles& triangles);

// Returns the positions of the attached vertices of a muscle in a pose, moved
// rigidly with their bodies (AttachmentTransform), #attached x 3, mm. `rest`:
// their positions in the rest pose.
Points AttachedPositions(const MuscleModel& model,
                         const AttachedVertices& attached,
                         const Points& rest,
                         const ScenePose& pose);

// A drift above this, mm, is anatomically implausible.
constexpr double kLargestDrift = 2;

// Returns the drift of each attachment. `points`: the fine mesh, #V x 3, mm;
// `positions`: the positions of the attached vertices on their bodies,
// #attached x 3, mm.
std::vector<AttachmentDrift> DriftOf(const std::vector<Attachment>& attachments,
                                     const AttachedVertices& attached,
                                     const Points& positions,
                                     const Points& points);

}  // namespace musclewarp
