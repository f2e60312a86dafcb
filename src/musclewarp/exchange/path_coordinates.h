// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// Which coordinates a path crosses, as the joints of a model say, not the
// moment arms: muscles beside it may push a muscle a little when joints move
// that it does not cross, and arms of a path that a joint passes through come
// and go.

// Returns the bodies between which a line of a muscle runs, as indices into the
// model: those of its path, if a muscle of the model has its name, or else
// those to which the muscle is attached in `frame`, by way of other muscles
// too. Bodies that the model does not have are left out.
std::vector<int> BodiesOfPath(const Model& model,
                              const FrameFigures& frame,
                              const std::string& muscle,
                              const std::string& line);

// Returns those of `coordinates`, indices into the model, that move some of the
// bodies relative to the others, as ascending indices into `coordinates`.
std::vector<int> CrossedCoordinates(const Model& model,
                                    const std::vector<int>& coordinates,
                                    const std::vector<int>& bodies);

// Returns the coordinate of a model with a name. Throws InputError, which names
// `where`, if there is none.
int CoordinateNamed(const Model& model,
                    const std::string& name,
                    const std::string& where);

// Returns the values of all coordinates of a model in a frame, rad or m: those
// that the frame does not give are at their default values, and coupled ones
// follow. Throws InputError as CoordinateNamed() does.
CoordinateValues ModelValuesOf(const Model& model,
                               const FrameFigures& frame,
                               const std::string& where);

}  // namespace musclewarp
