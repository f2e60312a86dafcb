// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

struct PreparedScene;

// Returns the exempt areas of all pairs of a muscle and a bone on whose body
// the muscle has an attachment that may penetrate.
std::vector<ExemptArea> ExemptAreas(const PreparedScene& scene);

}  // namespace musclewarp
