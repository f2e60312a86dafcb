// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/separating_planes.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// Returns the plane that keeps two triangles of one muscle apart as they were
// before the step or, if they were not, as they are at `targets` (#V x 3, mm),
// where the coarse mesh has them. Nothing if they are apart in neither place.
std::optional<SeparatingPlane> PlaneBetweenSheets(const StepOptions& options,
                                                  const ContactStep& step,
                                                  const Points& targets,
                                                  int muscle,
                                                  int f,
                                                  int g);

// Finds planes between the sheets of one muscle that face each other at a small
// distance before the step: the two sides of a crease, or of a part that is
// thin.
std::vector<SeparatingPlane> FindPlanesBetweenSheets(const StepOptions& options,
                                                     const ContactStep& step,
                                                     int muscle);

}  // namespace musclewarp
