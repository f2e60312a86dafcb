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

// Returns where the fibres of a muscle begin and end: in its attachments, if
// the scene names them, else in areas found on the mesh `fine`, which may be
// larger than those that are held (EndExtent::kClearOfOther).
KnownEnds EndsOfFibres(const TriangleSoup& fine,
                       const std::vector<BodySurface>& bodies,
                       const SceneMuscle& muscle,
                       bool names_attachments);

// Returns what a model needs to know of the inside of a muscle: the centres of
// voxels, also of the meshes `beyond`, through which its lines go on; and the
// fibres that resist bending, which do not depend on how many fibres the
// options ask for.
MuscleInterior InteriorOf(const TriangleSoup& muscle,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& ends,
                          const std::vector<const TriangleSoup*>& beyond,
                          const FibreOptions& options);

// Returns the action lines of a muscle as its hull carries them, sampled at
// distances of `spacing`, mm, along the muscle (SamplesAlong).
EmbeddedLines CarryActionLines(const MuscleModel& model, double spacing);

// Returns how much of the surface of a muscle lies on the bones of each body
// (VerticesNearBones), mm^2, without bodies on which nothing lies.
std::map<std::string, double> AreaOnBones(
    const TriangleSoup& muscle, const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
