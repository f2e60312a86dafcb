// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/orientation.h"

#include <vector>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

void Flip(Triangles* triangles, int f) {
  std::swap((*triangles)(f, 1), (*triangles)(f, 2));
}

struct Neighbour {
  int triangle;
  bool runs_same_way;
  int half_edge;
};

std::vector<std::vector<Neighbour>> NeighboursAcrossEdges(
    const Triangles& triangles, const EdgeUses& edges) {
  std::vector<std::vector<Neighbour>> neighbours(triangles.rows());
  for (const auto& uses : edges) {
    if (uses.size() != 2) continue;
    const bool same =
        OriginOf(triangles, uses[0]) == OriginOf(triangles, uses[1]);
    neighbours[uses[0] / 3].push_back({uses[1] / 3, same, uses[0]});
    neighbours[uses[1] / 3].push_back({uses[0] / 3, same, uses[1]});
  }
  return neighbours;
}

// For each component, true if it uses every edge an even number of times, so
// that it encloses a volume by itself.
std::vector<bool> EnclosingComponents(const EdgeUses& edges,
                                      const Components& components) {
  std::vector<bool> encloses(components.count, true);
  for (const auto& uses : edges) {
    for (const int h : uses) {
      const int label = components.label[h / 3];
      int own = 0;
      for (const int other : uses) {
        own += components.label[other / 3] == label;
      }
      if (own % 2 == 1) encloses[label] = false;
    }
  }
  return encloses;
}

// Returns +1 or -1 for each triangle (#F), opposite for neighbours that run the
// same way along their edge.
std::vector<int> RelativeSides(
    const TriangleSoup& soup,
    const std::vector<std::vector<Neighbour>>& neighbours,
    Flips* flips) {
  std::vector<int> side(soup.triangles.rows(), 0);
  std::vector<int> front;
  for (size_t seed = 0; seed < side.size(); ++seed) {
    if (side[seed] != 0) continue;
    side[seed] = 1;
    front.assign(1, static_cast<int>(seed));
    while (!front.empty()) {
      const int f = front.back();
      front.pop_back();
      for (const Neighbour& next : neighbours[f]) {
        const int wanted = next.runs_same_way ? -side[f] : side[f];
        if (side[next.triangle] == 0) {
          side[next.triangle] = wanted;
          front.push_back(next.triangle);
        } else if (side[next.triangle] != wanted && f < next.triangle) {
          ++flips->conflicts;
          const int h = next.half_edge;
          flips->conflict = (soup.points.row(OriginOf(soup.triangles, h)) +
                             soup.points.row(TargetOf(soup.triangles, h))) /
                            2;
        }
      }
    }
  }
  return side;
}

}  // namespace

Flips OrientConsistently(TriangleSoup* soup) {
  Triangles& triangles = soup->triangles;
  const EdgeUses edges(triangles);
  const Components components = ConnectedComponents(triangles, edges, 2);
  const std::vector<bool> encloses = EnclosingComponents(edges, components);

  Flips flips;
  const std::vector<int> side =
      RelativeSides(*soup, NeighboursAcrossEdges(triangles, edges), &flips);

  // For each component, the votes for keeping the triangles of side +1.
  std::vector<double> area(components.count, 0), volume(components.count, 0);
  for (int f = 0; f < triangles.rows(); ++f) {
    const Triangles triangle = triangles.row(f);
    area[components.label[f]] += side[f] * SurfaceArea(soup->points, triangle);
    volume[components.label[f]] +=
        side[f] * SignedVolume(soup->points, triangle);
  }
  for (int f = 0; f < triangles.rows(); ++f) {
    const int label = components.label[f];
    const int wanted =
        (encloses[label] ? volume[label] : area[label]) < 0 ? -1 : 1;
    if (side[f] == wanted) continue;
    Flip(&triangles, f);
    ++flips.flipped;
  }
  return flips;
}

}  // namespace musclewarp
