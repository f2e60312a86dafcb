// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Vertices that something other than the muscle's energy holds in place. They
// take no part in the volume correction: their rows of J_g are zero (paper
// section 3.3).
struct HeldVertices {
  std::vector<int> vertices;  // rising
  Points positions;           // #vertices x 3, mm

  bool IsEmpty() const { return vertices.empty(); }

  // `points` (#V x 3) with the held vertices where they are held.
  void PutBack(Points* points) const;
  // `gradient` (#V x 3) with their rows zero.
  void ClearRows(Points* gradient) const;

  // Of `points`, those with is_held (#V).
  static HeldVertices Of(const Points& points,
                         const std::vector<char>& is_held);
};

// What places single vertices of a muscle elsewhere than its energy does.
struct VertexCorrections {
  // Added to W X, n x 3, mm. No rows stand for zeros.
  Points fine_offset;
  HeldVertices held_coarse;
  HeldVertices held_fine;
};

// Where a muscle is: all of it that changes from pose to pose.
struct MuscleState {
  Points coarse;  // N x 3, mm: X
  VertexCorrections corrections;
};

// Returns the fine vertices of a state, W X + offset, n x 3, mm.
Points FinePoints(const MuscleModel& model, const MuscleState& state);

}  // namespace musclewarp
