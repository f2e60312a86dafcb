// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// Returns the motion that a scene describes itself, in place of a file:
//
//   "motion": { "frames": 15, "coordinates": { "hip_flexion_r": [-10, 60],
//                                              "knee_angle_r": [0, 90, 0] } }
//
// Its frames are at equal distances from 0 to 1 s, or a single one at 0 s. A
// coordinate passes through its values at equal distances of time, too, on
// straight lines; with one value it stays there. Values are in degrees for
// rotational coordinates and in mm, whatever the units of the scene, for
// translational ones; coupled ones are taken as they are. Coordinates that the
// object does not name, and those that follow others, are as MotionOf has them.
//
// A warning names a coordinate that has more values than there are frames.
// Throws InputError, which names the file and the field, for an unknown key or
// coordinate, if no coordinate is named, for values that are no list of numbers
// from -1e7 to 1e7, and for a number of frames that is not a whole one from 2
// to 100000; 1 is allowed if every coordinate has a single value.
CoordinateMotion RampedMotion(const JsonField& field, const Model& model);

}  // namespace musclewarp
