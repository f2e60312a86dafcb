// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/sheet_separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// For each half-edge, that of the triangle across the edge; -1 on a border.
using Mates = std::vector<int>;

void Pair(int h, int g, Mates* mates) {
  (*mates)[h] = g;
  (*mates)[g] = h;
}

// One triangle at a crowded edge.
struct Use {
  int half_edge;
  bool runs_up;  // from the lower to the higher point
  double angle;  // around the edge, counterclockwise seen against it
  bool is_open;  // true if its sheet has a border
  double area;   // of its sheet, mm^2
};

struct Sheets {
  Components components;
  std::vector<bool> is_open;
  std::vector<double> area;
};

Sheets FindSheets(const TriangleSoup& soup, const EdgeUses& edges) {
  Sheets sheets;
  sheets.components = ConnectedComponents(soup.triangles, edges, 2);
  sheets.is_open.assign(sheets.components.count, false);
  sheets.area.assign(sheets.components.count, 0);
  for (const auto& uses : edges) {
    if (uses.size() > 1) continue;
    sheets.is_open[sheets.components.label[uses[0] / 3]] = true;
  }
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    sheets.area[sheets.components.label[f]] +=
        SurfaceArea(soup.points, soup.triangles.row(f));
  }
  return sheets;
}

double AngleAround(const TriangleSoup& soup, int half_edge, bool runs_up) {
  const Triangles& triangles = soup.triangles;
  int low = OriginOf(triangles, half_edge);
  int high = TargetOf(triangles, half_edge);
  if (!runs_up) std::swap(low, high);
  const int apex = TargetOf(triangles, NextHalfEdge(half_edge));
  const Eigen::RowVector3d axis =
      (soup.points.row(high) - soup.points.row(low)).normalized();
  const Eigen::RowVector3d x = axis.unitOrthogonal();
  const Eigen::RowVector3d y = axis.cross(x);
  const Eigen::RowVector3d arm = soup.points.row(apex) - soup.points.row(low);
  return std::atan2(arm.dot(y), arm.dot(x));
}

// Removes uses until as many run up as run down.
void DropOddOnes(std::vector<Use>* uses) {
  const auto up = std::count_if(
      uses->begin(), uses->end(), [](const Use& use) { return use.runs_up; });
  auto excess = 2 * up - static_cast<std::ptrdiff_t>(uses->size());
  const bool drop_up = excess > 0;
  for (excess = std::abs(excess); excess > 0; --excess) {
    auto worst = uses->end();
    for (auto use = uses->begin(); use != uses->end(); ++use) {
      if (use->runs_up != drop_up) continue;
      if (worst == uses->end() ||
          std::make_pair(!use->is_open, use->area) <
              std::make_pair(!worst->is_open, worst->area)) {
        worst = use;
      }
    }
    uses->erase(worst);
  }
}

// The inside lies clockwise of a triangle that runs up and counterclockwise of
// one that runs down, so wedges of inside nest like brackets around the edge.
void PairByWedges(std::vector<Use> uses, Mates* mates) {
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::make_tuple(a.angle, a.runs_up, a.half_edge) <
           std::make_tuple(b.angle, b.runs_up, b.half_edge);
  });
  while (!uses.empty()) {
    size_t i = 0;
    while (uses[i].runs_up || !uses[(i + 1) % uses.size()].runs_up) ++i;
    const size_t j = (i + 1) % uses.size();
    Pair(uses[i].half_edge, uses[j].half_edge, mates);
    uses.erase(uses.begin() + std::max(i, j));
    uses.erase(uses.begin() + std::min(i, j));
  }
}

void PairAtCrowdedEdge(const TriangleSoup& soup,
                       const EdgeUses::Uses& half_edges,
                       const Sheets& sheets,
                       Mates* mates) {
  std::vector<Use> uses;
  for (const int h : half_edges) {
    const bool runs_up =
        OriginOf(soup.triangles, h) < TargetOf(soup.triangles, h);
    const int label = sheets.components.label[h / 3];
    uses.push_back({h,
                    runs_up,
                    AngleAround(soup, h, runs_up),
                    sheets.is_open[label],
                    sheets.area[label]});
  }
  DropOddOnes(&uses);
  PairByWedges(std::move(uses), mates);
}

// Gives a point of its own to every fan of corners that are joined by mates.
int SeparateFans(const Mates& mates,
                 const std::vector<bool>& may_separate,
                 TriangleSoup* soup) {
  Triangles& triangles = soup->triangles;
  DisjointSets fans(static_cast<int>(triangles.size()));
  for (int h = 0; h < triangles.size(); ++h) {
    if (mates[h] >= 0) fans.Join(h, NextHalfEdge(mates[h]));
  }
  std::vector<std::vector<int>> corners_of_fan(triangles.size());
  for (int h = 0; h < triangles.size(); ++h) {
    corners_of_fan[fans.Find(h)].push_back(h);
  }
  const int num_points = static_cast<int>(soup->points.rows());
  std::vector<int> widest(num_points, -1);
  for (int fan = 0; fan < triangles.size(); ++fan) {
    if (corners_of_fan[fan].empty()) continue;
    int& best = widest[OriginOf(triangles, fan)];
    if (best < 0 || corners_of_fan[fan].size() > corners_of_fan[best].size()) {
      best = fan;
    }
  }
  std::vector<int> copied;
  for (int fan = 0; fan < triangles.size(); ++fan) {
    if (corners_of_fan[fan].empty()) continue;
    const int v = OriginOf(triangles, fan);
    if (v >= num_points || !may_separate[v] || widest[v] == fan) continue;
    for (const int h : corners_of_fan[fan]) {
      triangles(h / 3, h % 3) = num_points + static_cast<int>(copied.size());
    }
    copied.push_back(v);
  }
  soup->points.conservativeResize(num_points + copied.size(), 3);
  for (size_t i = 0; i < copied.size(); ++i) {
    soup->points.row(num_points + i) = soup->points.row(copied[i]);
  }
  return static_cast<int>(copied.size());
}

// Splits the triangle of half-edge h at a new point m on that edge. The part at
// the origin of h keeps the index, the other becomes the last triangle.
void SplitTriangle(int h, int m, Triangles* triangles, Mates* mates) {
  const int f = h / 3;
  const int added = static_cast<int>(triangles->rows());
  const int next = NextHalfEdge(h);
  const int last = NextHalfEdge(next);
  triangles->conservativeResize(added + 1, 3);
  triangles->row(added) << m, TargetOf(*triangles, h),
      OriginOf(*triangles, last);
  (*triangles)(f, next % 3) = m;
  // Edges of the new triangle: m b, b c, c m.
  const int outer = (*mates)[next];
  mates->resize(3 * added + 3, -1);
  if (outer >= 0) Pair(3 * added + 1, outer, mates);
  Pair(next, 3 * added + 2, mates);
}

// Two sheets may share an edge and yet be one fan at both of its ends, so that
// copies of the ends cannot separate them. All sheets but the first get a point
// of their own in the middle of the edge. A call splits at most one edge of
// each triangle; returns the number of new points.
int SplitSharedEdges(Mates* mates, TriangleSoup* soup) {
  Triangles& triangles = soup->triangles;
  std::vector<bool> is_touched(triangles.rows(), false);
  std::vector<Eigen::RowVector3d> middles;
  const int num_points = static_cast<int>(soup->points.rows());
  const auto is_stale = [&](int h) {
    return h >= 3 * static_cast<int>(is_touched.size()) ||
           (h >= 0 && is_touched[h / 3]);
  };
  for (const auto& uses : EdgeUses(triangles)) {
    const bool is_shared =
        uses.size() > 2 || (uses.size() == 2 && (*mates)[uses[0]] != uses[1]);
    if (!is_shared || std::any_of(uses.begin(), uses.end(), [&](int h) {
          return is_stale(h) || is_stale((*mates)[h]);
        })) {
      continue;
    }
    for (const int h : uses) {
      const int g = (*mates)[h];
      if (h == uses[0] || g == uses[0] || is_touched[h / 3]) continue;
      const int m = num_points + static_cast<int>(middles.size());
      middles.push_back((soup->points.row(OriginOf(triangles, h)) +
                         soup->points.row(TargetOf(triangles, h))) /
                        2);
      is_touched[h / 3] = true;
      SplitTriangle(h, m, &triangles, mates);
      if (g < 0) continue;
      is_touched[g / 3] = true;
      SplitTriangle(g, m, &triangles, mates);
      const int h_rest = static_cast<int>(triangles.size()) - 6;
      Pair(h, h_rest + 3, mates);
      Pair(g, h_rest, mates);
    }
  }
  soup->points.conservativeResize(num_points + middles.size(), 3);
  for (size_t i = 0; i < middles.size(); ++i) {
    soup->points.row(num_points + i) = middles[i];
  }
  return static_cast<int>(middles.size());
}

}  // namespace

Separation SeparateAtNonManifoldEdges(TriangleSoup* soup) {
  const EdgeUses edges(soup->triangles);
  const Sheets sheets = FindSheets(*soup, edges);
  std::vector<bool> is_crowded(soup->points.rows(), false);
  Mates mates(soup->triangles.size(), -1);
  Separation separation;
  for (const auto& uses : edges) {
    if (uses.size() == 2) Pair(uses[0], uses[1], &mates);
    if (uses.size() <= 2) continue;
    ++separation.edges;
    PairAtCrowdedEdge(*soup, uses, sheets, &mates);
    is_crowded[OriginOf(soup->triangles, uses[0])] = true;
    is_crowded[TargetOf(soup->triangles, uses[0])] = true;
  }
  if (separation.edges == 0) return separation;
  separation.copies = SeparateFans(mates, is_crowded, soup);
  while (const int added = SplitSharedEdges(&mates, soup)) {
    separation.copies += added;
  }
  return separation;
}

int SeparateAtNonManifoldVertices(TriangleSoup* soup) {
  Mates mates(soup->triangles.size(), -1);
  for (const auto& uses : EdgeUses(soup->triangles)) {
    if (uses.size() == 2) Pair(uses[0], uses[1], &mates);
  }
  const std::vector<bool> all(soup->points.rows(), true);
  return SeparateFans(mates, all, soup);
}

}  // namespace musclewarp
