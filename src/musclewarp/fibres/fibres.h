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

// The options of MakeFibres.
struct FibreOptions {
  // The number of fibres to make.
  int fibres = 100;

  // The number of straight segments of a fibre. The default is that of Modenese
  // and Kohout, "Automated Generation of Three-Dimensional Complex Muscle
  // Geometries for Use in Personalised Musculoskeletal Models" (2020).
  int segments = 15;

  // About how many voxels the grid has on which the courses of the fibres are
  // found. More of them follow thin parts better and take longer.
  int voxels = 6000;

  // Returns true if the options can be used; otherwise sets *error to a
  // sentence that names the field and the rule.
  bool IsValid(std::string* error) const;
};

// Returns fibres of a muscle in the rest pose. Each is a polyline from the
// origin to the insertion, with options.segments + 1 points (rows, mm) at equal
// distances, inside the surface or, where the muscle is thinner than a voxel,
// on it. The fibres do not cross, and each stands for an equal share of the
// muscle's widest section. Those shorter than a tenth of the median are left
// out. There are fewer than asked for if the section is too small, and none if
// the muscle is too thin.
//
// `bodies` and `known` say where the muscle begins and ends, as for
// FindMuscleEnds. Preconditions: the options are valid (CHECKed); the mesh is
// closed and oriented outward.
std::vector<Points> MakeFibres(const TriangleSoup& muscle,
                               const std::vector<BodySurface>& bodies,
                               const KnownEnds& known,
                               const FibreOptions& options);

// Returns lines of action for a muscle that has none in the scene: its centre
// line if `count` is 1, else a fan of `count` courses of its fibres. A line has
// nine points and is called `name`_1, `name`_2 and so on.
//
// A line goes on to the tips of the muscle, through tendons too. If there are
// attachments, it ends there. The ends of a line are fixed to the bodies of the
// origin and the insertion. The points between are guided by the nearest body,
// with the bodies in one order along the line, and the muscle slides past them
// (ActionLine::slides).
//
// Preconditions: count is above 0 (CHECKed); the mesh is closed and oriented
// outward. Throws InputError if there is no bone to follow or the muscle is too
// thin.
std::vector<ActionLine> MakeLines(const std::string& name,
                                  const TriangleSoup& muscle,
                                  const std::vector<BodySurface>& bodies,
                                  const std::vector<Attachment>& attachments,
                                  int count);

}  // namespace musclewarp
