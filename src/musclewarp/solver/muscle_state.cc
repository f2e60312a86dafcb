// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_state.h"

#include "musclewarp/geometry/fine_map.h"

namespace musclewarp {

HeldVertices HeldVertices::Of(const Points& points,
                              const std::vector<char>& is_held) {
  HeldVertices held;
  for (size_t i = 0; i < is_held.size(); ++i) {
    if (is_held[i]) held.vertices.push_back(static_cast<int>(i));
  }
  held.positions.resize(held.vertices.size(), 3);
  for (size_t k = 0; k < held.vertices.size(); ++k) {
    held.positions.row(k) = points.row(held.vertices[k]);
  }
  return held;
}

void HeldVertices::PutBack(Points* points) const {
  for (size_t k = 0; k < vertices.size(); ++k) {
    points->row(vertices[k]) = positions.row(k);
  }
}

void HeldVertices::ClearRows(Points* gradient) const {
  for (const int v : vertices) gradient->row(v).setZero();
}

Points FinePoints(const MuscleModel& model, const MuscleState& state) {
  Points fine = Product(model.fine_from_coarse, state.coarse);
  if (state.corrections.fine_offset.rows() > 0)
    fine += state.corrections.fine_offset;
  return fine;
}

}  // namespace musclewarp
