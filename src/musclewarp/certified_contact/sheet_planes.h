// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/separating_planes.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// Returns the plane that separates two triangles of one muscle as before the
// step or, if they were inseparable then, as at `targets` (#V x 3, mm). Empty
// if they are separable in neither state.
std::optional<SeparatingPlane> PlaneBetweenSheets(const StepOptions& options,
                                                  const ContactStep& step,
                                                  const Points& targets,
                                                  int muscle,
                                                  int f,
                                                  int g);

// Finds planes between sheets of one muscle that face each other at a small
// distance before the step (PlaneSearchOptions::sheet_distance): the two sides
// of a crease or of a thin part.
std::vector<SeparatingPlane> FindPlanesBetweenSheets(const StepOptions& options,
                                                     const ContactStep& step,
                                                     int muscle);

}  // namespace musclewarp
