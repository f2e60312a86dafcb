// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// Postures that cover ranges of coordinates, in place of a motion.
struct DesignedPostures {
  std::string design;       // "latin_hypercube" or "grid"
  CoordinateMotion motion;  // an entry for each posture; all times are 0
  std::string note;         // a sentence on the coordinates and their ranges
};

// Returns true if the "motion" of a scene file is a design of postures.
bool IsDesign(const JsonField& field);

// Returns the postures that a scene file describes:
//
//   "motion": { "design": "latin_hypercube", "postures": 200, "seed": 1,
//               "coordinates": { "hip_flexion_r": [-20, 100],
//                                "hip_rotation_r": "model" } }
//
// A Latin hypercube has so many postures (LatinHypercube; seed 1 if none is
// given). A grid has at most so many, with the ends of the ranges and spacings
// that are as alike as possible (GridCounts); it has no seed.
//
// Ranges are in degrees, or mm for translational coordinates. "model" stands
// for the range that the model has, and "coordinates" may be a list of names,
// all with that range. Without "coordinates", all are used that are neither
// locked nor coupled to others and move some of `bodies` relative to the
// others. Coordinates that are not named have their default values, and coupled
// ones follow.
//
// Throws InputError, which names the file and the field, for an unknown key,
// design or coordinate, a coordinate that is locked or coupled, a range that is
// not two rising numbers from -1e7 to 1e7 or that the model does not have, a
// number of postures that is not an integer from 1 to 20000 or too small for a
// grid, and a seed that is not an integer from 0 to 4294967295.
DesignedPostures ReadDesignedPostures(const JsonField& field,
                                      const Model& model,
                                      const std::vector<std::string>& bodies);

// Brings the postures of a design into the order in which they are visited, and
// returns for each the one from which it is reached, or -1 for the rest pose
// (TreeFrom). Moves are compared in rad; 80 mm count as 20 degrees, as in the
// limits of steps.
std::vector<int> VisitAsTree(const Model& model,
                             const CoordinateValues& rest,
                             CoordinateMotion* postures);

}  // namespace musclewarp
