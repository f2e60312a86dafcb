// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns how large the body of a scene is against a human one, from a measure
// of its muscles that human muscles, long or stout, differ least in: the cube
// root of the geometric mean of their volumes, mm. Human scenes, whose muscles
// hold about 4 cm3 (a forearm) to 1000 cm3 (a gluteus maximus) in that mean,
// have size 1. Any other body has the power of two by which the measure is that
// of the muscles of a human leg, 31 to 62 mm: 1/32 for a mouse. Scenes that
// differ by a power of two are thus computed alike, to the last bit, unless one
// of them is of human size and not of that of a leg. Reads the meshes of
// muscles. Throws InputError if one cannot be read, has coordinates that are
// not allowed, or has not the size of a muscle (CheckMuscleSize).
double BodySizeOf(const Scene& scene);

// Returns a scene, given in mm, in units of its body's size, with body_size and
// a note for the user if that is not 1.
Scene InBodyUnits(Scene scene);

}  // namespace musclewarp
