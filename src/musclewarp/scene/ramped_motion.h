// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// Returns the motion that a scene file describes itself, without a motion file:
//
//   "motion": { "frames": 15, "coordinates": { "hip_flexion_r": [-10, 60],
//                                              "knee_angle_r": [0, 90, 0] } }
//
// Its frames are equally spaced in time from 0 to 1 s; a single frame is at 0
// s. A coordinate is piecewise linear through its values, which are equally
// spaced in time too; with a single value it is constant. Values of rotational
// coordinates are in degrees, those of translational coordinates in mm,
// regardless of the units of the scene, and those of coupled coordinates in the
// units of the model. MotionOf determines the coordinates that the object does
// not name, and those that depend on others.
//
// A warning names each coordinate that has more values than there are frames.
// Throws InputError, which names the file and the field, for an unknown key or
// coordinate, an empty list of coordinates, values that are not a list of
// numbers from -1e7 to 1e7, and a number of frames that is not an integer from
// 2 to 100000; 1 is allowed if every coordinate has a single value.
CoordinateMotion RampedMotion(const JsonField& field, const Model& model);

}  // namespace musclewarp
