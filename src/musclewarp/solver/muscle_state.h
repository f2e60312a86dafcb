// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Vertices of a mesh that are fixed at given positions, whatever the energy of
// the muscle asks of them. The volume correction leaves them alone: their rows
// of J_g are zero (paper section 3.3, "masking").
struct HeldVertices {
  std::vector<int> vertices;  // indices in rising order
  Points positions;           // #vertices x 3, mm

  bool IsEmpty() const { return vertices.empty(); }

  // Overwrites the held vertices among `points` (#V x 3, mm) with the positions
  // at which they are held.
  void PutBack(Points* points) const;

  // Sets the rows of the held vertices in `gradient` (#V x 3) to zero.
  void ClearRows(Points* gradient) const;

  // Returns the vertices with a true entry in `is_held` (#V), held at their
  // positions in `points` (#V x 3, mm).
  static HeldVertices Of(const Points& points,
                         const std::vector<char>& is_held);
};

// Moves of single vertices away from where the energy of the muscle has them.
// By default there are none.
struct VertexCorrections {
  // Added to the fine vertices W X; n x 3, mm. A matrix without rows stands for
  // zeros.
  Points fine_offset;

  // Coarse vertices fixed among X, and fine vertices fixed among W X + offset.
  HeldVertices held_coarse;
  HeldVertices held_fine;
};

// The shape of a muscle in one pose: all of it that changes while a solver
// iterates.
struct MuscleState {
  Points coarse;  // N x 3, mm: X
  VertexCorrections corrections;
};

// Returns the fine vertices of a state, W X + offset, n x 3, mm. Held vertices
// are not put back: a held fine vertex is where it is held once its offset has
// been set accordingly (RestoreVolume).
Points FinePoints(const MuscleModel& model, const MuscleState& state);

}  // namespace musclewarp
