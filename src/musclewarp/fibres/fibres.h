// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

struct FibreOptions {
  int fibres = 100;
  int segments = 15;  // of a fibre; Modenese and Kohout (2020) have 15
  int voxels = 6000;  // of the grid the fibres are found on, about

  bool IsValid(std::string* error) const;
};

// Fibres of a muscle at rest: polylines inside the surface from origin to
// insertion, #segments + 1 points at equal distances each, mm, that do not
// cross, each for an equal share of the muscle's widest section. Fewer if the
// section is too small for so many, none in a muscle too thin. Preconditions
// (CHECKed): the options are valid, the mesh is closed and outward.
std::vector<Points> MakeFibres(const TriangleSoup& muscle,
                               const std::vector<BodySurface>& bodies,
                               const std::vector<Attachment>& attachments,
                               const FibreOptions& options);

// Lines of action for a muscle that has none, named `name`_1 ...: a centre line
// (count 1) or a fan of the courses of its fibres, of five points each. The
// ends follow the bodies of origin and insertion, the points between the bone
// they are nearest to, in one order along the line. Precondition (CHECKed):
// count is above 0, the mesh is closed and outward. Throws InputError if there
// is no bone to follow, or the muscle is too thin.
std::vector<ActionLine> MakeLines(const std::string& name,
                                  const TriangleSoup& muscle,
                                  const std::vector<BodySurface>& bodies,
                                  const std::vector<Attachment>& attachments,
                                  int count);

}  // namespace musclewarp
