// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Returns the direction of the nearest line at every fine vertex at rest, or of
// the axis along which the muscle is longest if it has no lines. n x 3, of any
// length.
Points CourseOf(const MuscleModel& model);

}  // namespace musclewarp
