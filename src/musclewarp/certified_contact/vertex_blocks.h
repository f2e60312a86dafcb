// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The vertices of a mesh in blocks of neighbours, and the blocks in colours:
// no edge joins two blocks of one colour. Gauss-Seidel sweeps take colour after
// colour, the blocks of a colour on several threads, and their result depends
// neither on the number of threads nor on which is quicker.
struct VertexBlocks {
  // The vertices of block b are vertices[first[b]] to vertices[first[b + 1] -
  // 1], in rising order. Every vertex is in one block.
  std::vector<int> vertices;
  std::vector<int> first = {0};

  // By colour: its blocks.
  std::vector<std::vector<int>> colours;

  int num_blocks() const { return static_cast<int>(first.size()) - 1; }
};

// Divides the vertices at `points` (#V x 3) into blocks of at most `largest`.
// The neighbours of vertex v are neighbours[first[v]] to
// neighbours[first[v + 1] - 1]. Precondition (CHECKed): `largest` is positive.
VertexBlocks MakeVertexBlocks(const Points& points,
                              const std::vector<int>& first,
                              const std::vector<int>& neighbours,
                              int largest);

}  // namespace musclewarp
