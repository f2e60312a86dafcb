// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/self_crossing_removal.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "musclewarp/cgal/self_intersection_repair.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/pieces.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

using Place = std::array<double, 3>;

// Fills in how the new mesh differs from the old one.
void Compare(const TriangleSoup& before,
             const TriangleSoup& after,
             SelfCrossingRemoval* removal) {
  std::set<Place> old;
  for (const auto p : before.points.rowwise()) old.insert({p[0], p[1], p[2]});
  const TriangleBvh tree(before.points, before.triangles);
  for (const auto p : after.points.rowwise()) {
    if (old.count({p[0], p[1], p[2]}) > 0) continue;
    ++removal->new_vertices;
    removal->place += p;
    const double distance =
        tree.ClosestPoint(p, std::numeric_limits<double>::infinity()).distance;
    removal->farthest = std::max(removal->farthest, distance);
  }
  if (removal->new_vertices > 0) removal->place /= removal->new_vertices;
}

// Returns the triangles within 20 typical edges of those that cross, which is
// as far as seven rounds of repair go where triangles are alike.
std::vector<int> TrianglesAround(
    const TriangleSoup& soup,
    const std::vector<std::pair<int, int>>& crossings) {
  std::set<int> crossing;
  for (const auto& [f, g] : crossings) crossing.insert({f, g});
  const TriangleBvh tree(
      soup.points,
      soup.triangles(std::vector<int>(crossing.begin(), crossing.end()),
                     Eigen::all));
  const double around = 20 * TypicalEdge(soup.points, soup.triangles);
  std::vector<int> triangles;
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    const Eigen::RowVector3d centre =
        CornersOf(soup.points, soup.triangles.row(f)).colwise().mean();
    if (tree.IsWithin(centre, around)) triangles.push_back(f);
  }
  return triangles;
}

// Removes the crossings of one closed manifold with itself.
SelfCrossingRemoval RemoveFromSurface(TriangleSoup* soup) {
  SelfCrossingRemoval removal;
  const std::vector<std::pair<int, int>> crossings = SelfIntersections(*soup);
  removal.pairs_before = static_cast<int>(crossings.size());
  removal.pairs_after = removal.pairs_before;
  if (crossings.empty()) return removal;
  TriangleSoup repaired =
      WithSelfIntersectionsRepaired(*soup, TrianglesAround(*soup, crossings));
  int pairs = static_cast<int>(SelfIntersections(repaired).size());
  if (pairs > 0) {
    // A patch may cross what lies farther away, where triangles are large.
    std::vector<int> all(soup->triangles.rows());
    std::iota(all.begin(), all.end(), 0);
    repaired = WithSelfIntersectionsRepaired(*soup, all);
    pairs = static_cast<int>(SelfIntersections(repaired).size());
  }
  if (pairs >= removal.pairs_before || !CountDefects(repaired).IsClean()) {
    return removal;
  }
  removal.pairs_after = pairs;
  Compare(*soup, repaired, &removal);
  *soup = std::move(repaired);
  return removal;
}

void Add(const SelfCrossingRemoval& piece, SelfCrossingRemoval* sum) {
  sum->pairs_before += piece.pairs_before;
  sum->pairs_after += piece.pairs_after;
  const int vertices = sum->new_vertices + piece.new_vertices;
  if (piece.new_vertices > 0) {
    sum->place += (piece.place - sum->place) * piece.new_vertices / vertices;
  }
  sum->new_vertices = vertices;
  sum->farthest = std::max(sum->farthest, piece.farthest);
}

}  // namespace

SelfCrossingRemoval RemoveSelfCrossings(TriangleSoup* soup) {
  std::vector<TriangleSoup> pieces = PiecesOf(*soup);
  if (pieces.size() == 1) return RemoveFromSurface(soup);
  SelfCrossingRemoval sum;
  for (TriangleSoup& piece : pieces) Add(RemoveFromSurface(&piece), &sum);
  if (sum.new_vertices > 0) *soup = Joined(pieces);
  return sum;
}

}  // namespace musclewarp
