// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Neighbouring triangles of a mesh cannot be told apart by boxes, and testing
// each two of them is most of a search for self-crossings. The triangles around
// a vertex, its star, are settled at once instead.

// The neighbours of each vertex in order around it, which depend on the
// triangles only.
class VertexRings {
 public:
  VertexRings(const Triangles& triangles, Eigen::Index num_points);

  int num_vertices() const { return static_cast<int>(first_.size()) - 1; }

  // The ring of a vertex: its triangles are (v, ring[i], ring[i + 1]) and (v,
  // last, first). It is empty if the triangles do not go round the vertex once,
  // all in the same sense.
  const int* begin(int v) const { return ring_.data() + first_[v]; }
  const int* end(int v) const { return ring_.data() + first_[v + 1]; }

 private:
  std::vector<int> first_, ring_;
};

// Returns true if it is certain that no two triangles of the star of vertex v
// meet outside of the corner or edge that they have in common: all of them turn
// their front to `up`, and seen from there their edges go round v once, so that
// they lie over different sectors. Signs are certain by bounds of the rounding.
// The answer is never wrongly true, whatever `up` is, and false means nothing.
bool IsProperStar(const VertexRings& rings,
                  const Points& points,
                  int v,
                  const Eigen::RowVector3d& up);

// Returns for each vertex (#V) whether its star is proper as seen from the
// mean normal of its triangles.
std::vector<char> ProperStars(const VertexRings& rings, const Points& points);

// Returns true if triangles f and g share a vertex whose star is proper.
inline bool ShareProperStar(const Triangles& triangles,
                            const std::vector<char>& is_proper,
                            int f,
                            int g) {
  for (int i = 0; i < 3; ++i) {
    const int v = triangles(f, i);
    if ((v == triangles(g, 0) || v == triangles(g, 1) ||
         v == triangles(g, 2)) &&
        is_proper[v]) {
      return true;
    }
  }
  return false;
}

}  // namespace musclewarp
