// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/vertex_blocks.h"

#include <glog/logging.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "musclewarp/proximity/triangle_halves.h"

namespace musclewarp {
namespace {

// Halves the vertices in [begin, end) until each part is a block.
void Divide(
    const Points& points, int largest, int* begin, int* end, VertexBlocks* to) {
  if (end - begin > largest) {
    int* const middle = begin + (end - begin) / 2;
    SplitAlongLongestSide(points, begin, middle, end);
    Divide(points, largest, begin, middle, to);
    Divide(points, largest, middle, end, to);
    return;
  }
  std::sort(begin, end);
  to->vertices.insert(to->vertices.end(), begin, end);
  to->first.push_back(static_cast<int>(to->vertices.size()));
}

// Gives each block the colour with the fewest blocks among those that no
// neighbour has, so that there are few colours, and many blocks of each.
void Colour(const std::vector<std::set<int>>& neighbours,
            VertexBlocks* blocks) {
  std::vector<int> colour_of(neighbours.size(), -1);
  for (size_t b = 0; b < neighbours.size(); ++b) {
    std::set<int> taken;
    for (const int other : neighbours[b]) taken.insert(colour_of[other]);
    int best = -1;
    for (int c = 0; c < static_cast<int>(blocks->colours.size()); ++c) {
      if (taken.count(c) > 0) continue;
      if (best < 0 ||
          blocks->colours[c].size() < blocks->colours[best].size()) {
        best = c;
      }
    }
    if (best < 0) {
      best = static_cast<int>(blocks->colours.size());
      blocks->colours.emplace_back();
    }
    colour_of[b] = best;
    blocks->colours[best].push_back(static_cast<int>(b));
  }
}

}  // namespace

VertexBlocks MakeVertexBlocks(const Points& points,
                              const std::vector<int>& first,
                              const std::vector<int>& neighbours,
                              int largest) {
  CHECK_GT(largest, 0);
  VertexBlocks blocks;
  const int count = static_cast<int>(points.rows());
  if (count == 0) return blocks;
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  Divide(points, largest, order.data(), order.data() + count, &blocks);
  std::vector<int> block_of(count);
  for (int b = 0; b < blocks.num_blocks(); ++b) {
    for (int k = blocks.first[b]; k < blocks.first[b + 1]; ++k) {
      block_of[blocks.vertices[k]] = b;
    }
  }
  std::vector<std::set<int>> around(blocks.num_blocks());
  for (int v = 0; v < count; ++v) {
    for (int e = first[v]; e < first[v + 1]; ++e) {
      const int other = block_of[neighbours[e]];
      if (other != block_of[v]) around[block_of[v]].insert(other);
    }
  }
  Colour(around, &blocks);
  return blocks;
}

}  // namespace musclewarp
