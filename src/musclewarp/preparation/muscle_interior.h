// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/fibres/fibres.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/embedded_lines.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Returns the ends of the fibres of a muscle: its attachments, if the scene
// names them, or else areas detected on the mesh `fine`, which may be larger
// than the attachments (EndExtent::kClearOfOther).
KnownEnds EndsOfFibres(const TriangleSoup& fine,
                       const std::vector<BodySurface>& bodies,
                       const SceneMuscle& muscle,
                       bool names_attachments);

// Returns the data that a model needs about the interior of a muscle: the
// centres of its voxels, those of the meshes `beyond`, through which its lines
// continue, and the fibres that resist bending, whose number does not depend on
// the options.
MuscleInterior InteriorOf(const TriangleSoup& muscle,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& ends,
                          const std::vector<const TriangleSoup*>& beyond,
                          const FibreOptions& options);

// Returns the action lines of a muscle embedded in its hull, sampled at
// intervals of `spacing` (mm) along the muscle (SamplesAlong).
EmbeddedLines CarryActionLines(const MuscleModel& model, double spacing);

// Returns the surface area of a muscle that lies on the bones of each body
// (VerticesNearBones), mm^2. Bodies without such an area are omitted.
std::map<std::string, double> AreaOnBones(
    const TriangleSoup& muscle, const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
