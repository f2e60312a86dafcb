// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace musclewarp {

// Larger than every distance, mm: where a search for the nearest starts, and
// the limit of one that has none.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace musclewarp
