// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Vertices that contact holds in place: they take no part in the volume
// correction, which is to say their rows of J_g are zero (paper section 3.3).
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

// What contact adds to a muscle.
struct MuscleContact {
  // X as it would be without, N x 3, mm; no rows: as it is.
  Points free_coarse;
  // Moves of the fine vertices beside W X, n x 3, mm; no rows: none.
  Points fine_offset;
  HeldVertices held_coarse;
  HeldVertices held_fine;
};

// Where a muscle is; the only thing of it that moves.
struct MuscleState {
  Points coarse;  // N x 3, mm: X
  MuscleContact contact;
};

// X without contact, N x 3, mm.
const Points& FreeCoarse(const MuscleState& state);

// The fine mesh of a state, W X + offset, n x 3, mm.
Points FinePoints(const MuscleModel& model, const MuscleState& state);

}  // namespace musclewarp
