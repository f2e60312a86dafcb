// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/page/packed_numbers.h"

namespace musclewarp {

// A motion of points, packed.
struct PackedMotion {
  // What tools/report/src/data/motion.ts reads: the first pose, modes, their
  // weights in each pose, and corrections.
  nlohmann::ordered_json json;
  double max_error = 0;  // of a coordinate, mm; at most the tolerance
};

// Packs the positions of points (#V x 3, mm) in all poses, which each have the
// same number, so that every coordinate is within `tolerance` (mm). Motions of
// muscles have few shapes: positions are those of the first pose and a weighted
// sum of modes (the principal components of what moves, whose number is chosen
// so that all takes fewest bytes); what is still farther off than the tolerance
// is corrected one by one. Preconditions (CHECKed): there is a pose;
// `tolerance` > 0.
PackedMotion PackMotion(const std::vector<const Points*>& poses,
                        double tolerance,
                        PackedNumbers* packed);

}  // namespace musclewarp
