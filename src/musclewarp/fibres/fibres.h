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

  // The number of straight segments of a fibre. The default is from Modenese
  // and Kohout, "Automated Generation of Three-Dimensional Complex Muscle
  // Geometries for Use in Personalised Musculoskeletal Models" (2020).
  int segments = 15;

  // The approximate number of voxels in the grid on which fibres are computed.
  // More voxels follow thin parts better and take longer.
  int voxels = 6000;

  // Returns true if the options can be used; otherwise sets *error to a
  // sentence that names the field and the rule.
  bool IsValid(std::string* error) const;
};

// Returns fibres of a muscle in the rest pose. Each is a polyline from the
// origin to the insertion, with options.segments + 1 equally spaced points
// (rows, mm), inside the surface or, where the muscle is thinner than a voxel,
// on it. The fibres do not cross, and each represents an equal share of the
// muscle's widest section. Fibres shorter than a tenth of the median are
// omitted. The result has fewer fibres than requested if the section is too
// small, and none if the muscle is too thin.
//
// `bodies` and `known` determine the ends of the muscle, as in FindMuscleEnds.
// Preconditions: the options are valid (CHECKed); the mesh is closed and
// oriented outward.
std::vector<Points> MakeFibres(const TriangleSoup& muscle,
                               const std::vector<BodySurface>& bodies,
                               const KnownEnds& known,
                               const FibreOptions& options);

// How many points a made line has.
enum class LinePoints {
  // One every 10 mm, at least nine; all lines of a muscle have equally many.
  kEvery10Mm,
  kNine,
};

// Returns how many points lines at distances of 10 mm (of the mean length)
// have, at least nine. Precondition (CHECKed): there is a line.
int NumLinePoints(const std::vector<Points>& lines);

// Returns action lines for a muscle that has none in the scene: its centre line
// if `count` is 1, otherwise `count` of its fibres, spread like a fan. A line
// is called `name`_1, `name`_2 and so on; points are in mm.
//
// Lines extend to the tips of the muscle, also through its tendons; with
// attachments, they end at these. The ends of a line are fixed to the bodies of
// the origin and the insertion. The points between are guided by the nearest
// body, where each body guides one contiguous part of the line, and the muscle
// slides past them (ActionLine::slides).
//
// Preconditions: count is above 0 (CHECKed); the mesh is closed and oriented
// outward. Throws InputError if there are no bones or the muscle is too thin.
std::vector<ActionLine> MakeLines(const std::string& name,
                                  const TriangleSoup& muscle,
                                  const std::vector<BodySurface>& bodies,
                                  const std::vector<Attachment>& attachments,
                                  int count,
                                  LinePoints points);

}  // namespace musclewarp
