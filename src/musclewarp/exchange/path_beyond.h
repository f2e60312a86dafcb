// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// A muscle carries the part of its line that is in its mesh: the line of a
// muscle that ends on a tendon with a mesh of its own goes on to the bone
// (ContinueLines). A path of a model is the whole line.

// What of a path is before and after the part that a muscle carries.
struct PartsBeyond {
  double length = 0;                        // of both, mm
  int points_before = 0, points_after = 0;  // of the path
};

// Returns what of a path (#P x 3, mm) is before the first and after the last
// point of `carried` (#C x 3, mm), both at rest. It is nothing if one of these
// points is farther than 5 mm from the path, so that the path is none on which
// the muscle lies at rest, and if the parts are shorter than 1e-3 mm. Lines
// that are made of the same mesh, repaired in two ways, are 2 to 4 mm apart at
// a tendon.
PartsBeyond FindPartsBeyond(const Points& path, const Points& carried);

// Returns the points of a muscle of a model at the default values of its
// coordinates, #P x 3, mm, in the ground. There are none if its path is not
// known or has moving or conditional points.
Points DefaultPath(const Model& model, int muscle);

// Returns a line (#P x 3, mm, in the ground) that a muscle carries, with the
// points of the path of `muscle` of the model before and after it, where their
// bodies have them at these values.
Points WithPartsBeyond(const Points& line,
                       const PartsBeyond& beyond,
                       const Model& model,
                       const std::string& muscle,
                       const CoordinateValues& values);

}  // namespace musclewarp
