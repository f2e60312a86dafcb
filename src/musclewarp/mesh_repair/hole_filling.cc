// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/hole_filling.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/invalid_option.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Edges = std::set<std::pair<int, int>>;  // lower, higher point

Edges AllEdges(const Triangles& triangles) {
  Edges edges;
  for (int h = 0; h < triangles.size(); ++h) {
    edges.insert(std::minmax({OriginOf(triangles, h), TargetOf(triangles, h)}));
  }
  return edges;
}

// The triangulation of a loop that has the least area, by the dynamic program
// of Barequet and Sharir, "Filling gaps in the boundary of a polyhedron"
// (1995).
class LoopTriangulation {
 public:
  LoopTriangulation(const BorderLoop& loop,
                    const Points& points,
                    const Edges& taken);

  // The area, mm^2; infinite if every triangulation needs a taken chord.
  double Area() const { return Best(0, size_ - 1); }
  std::vector<std::array<int, 3>> Triangles() const;

 private:
  double Best(int i, int j) const { return best_[i * size_ + j]; }
  void Solve(int i, int j, const Points& points);

  const BorderLoop& loop_;
  int size_;
  std::vector<double> best_;  // least area of the part between i and j
  std::vector<int> apex_;     // its triangle on the chord i j
};

LoopTriangulation::LoopTriangulation(const BorderLoop& loop,
                                     const Points& points,
                                     const Edges& taken)
    : loop_(loop),
      size_(static_cast<int>(loop.size())),
      best_(size_ * size_, 0),
      apex_(size_ * size_, -1) {
  for (int width = 2; width < size_; ++width) {
    for (int i = 0; i + width < size_; ++i) {
      const int j = i + width;
      const bool is_chord = width < size_ - 1;
      if (is_chord && taken.count(std::minmax({loop[i], loop[j]}))) {
        best_[i * size_ + j] = kInfinity;
      } else {
        Solve(i, j, points);
      }
    }
  }
}

void LoopTriangulation::Solve(int i, int j, const Points& points) {
  // A triangle of no area is worse than any sliver, but better than a hole.
  constexpr double kPenalty = 1e12;
  const Eigen::RowVector3d start = points.row(loop_[i]);
  const Eigen::RowVector3d chord = points.row(loop_[j]) - points.row(loop_[i]);
  double best = kInfinity;
  for (int k = i + 1; k < j; ++k) {
    const double parts = Best(i, k) + Best(k, j);
    if (parts >= best) continue;
    const Eigen::RowVector3d arm = points.row(loop_[k]) - start;
    const double area = arm.cross(chord).norm() / 2;
    const double total = parts + (area > 0 ? area : kPenalty);
    if (total >= best) continue;
    best = total;
    apex_[i * size_ + j] = k;
  }
  best_[i * size_ + j] = best;
}

std::vector<std::array<int, 3>> LoopTriangulation::Triangles() const {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::pair<int, int>> open = {{0, size_ - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const int k = apex_[i * size_ + j];
    triangles.push_back({loop_[i], loop_[k], loop_[j]});
    open.push_back({i, k});
    open.push_back({k, j});
  }
  return triangles;
}

Triangles ToTriangles(const std::vector<std::array<int, 3>>& corners) {
  Triangles triangles(corners.size(), 3);
  for (size_t f = 0; f < corners.size(); ++f) {
    triangles.row(f) << corners[f][0], corners[f][1], corners[f][2];
  }
  return triangles;
}

void Append(const Triangles& added, Triangles* triangles) {
  triangles->conservativeResize(triangles->rows() + added.rows(), 3);
  triangles->bottomRows(added.rows()) = added;
}

// Splits every chord of a filling that is an edge of the mesh already. The new
// point is in the middle of the chord, but moved a little towards the corners
// beside it so as not to lie on that edge.
void SplitTakenChords(const Edges& taken,
                      std::vector<std::array<int, 3>>* filling,
                      Points* points) {
  constexpr double kAside = 0.01;
  std::map<std::pair<int, int>, std::vector<size_t>> triangles_of_chord;
  for (size_t f = 0; f < filling->size(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const auto edge =
          std::minmax({(*filling)[f][c], (*filling)[f][(c + 1) % 3]});
      triangles_of_chord[edge].push_back(f);
    }
  }
  for (const auto& [chord, around] : triangles_of_chord) {
    if (around.size() < 2 || taken.count(chord) == 0) continue;
    const auto [a, b] = chord;
    const int middle = static_cast<int>(points->rows());
    Eigen::RowVector3d position =
        (0.5 - kAside) * (points->row(a) + points->row(b));
    // Earlier splits may have moved the chord to a later triangle.
    const size_t old_size = filling->size();
    for (size_t f = 0; f < old_size; ++f) {
      auto& corners = (*filling)[f];
      const auto at_a = std::find(corners.begin(), corners.end(), a);
      const auto at_b = std::find(corners.begin(), corners.end(), b);
      if (at_a == corners.end() || at_b == corners.end()) continue;
      for (const int corner : corners) {
        if (corner != a && corner != b)
          position += kAside * points->row(corner);
      }
      auto other = corners;
      *at_b = middle;
      std::replace(other.begin(), other.end(), a, middle);
      filling->push_back(other);
    }
    points->conservativeResize(middle + 1, 3);
    points->row(middle) = position;
  }
}

// Returns the filling of least area that avoids taken chords; or, if the detour
// around them is too large (it may leave the hole altogether), the filling of
// least area, in which taken chords are split.
Triangles FillLoop(const BorderLoop& loop, const Edges& taken, Points* points) {
  constexpr double kWorstDetour = 2;
  const LoopTriangulation direct(loop, *points, Edges());
  const LoopTriangulation detour(loop, *points, taken);
  if (detour.Area() <= kWorstDetour * direct.Area()) {
    return ToTriangles(detour.Triangles());
  }
  auto filling = direct.Triangles();
  SplitTakenChords(taken, &filling, points);
  return ToTriangles(filling);
}

}  // namespace

std::vector<BorderLoop> FindBorderLoops(const Triangles& triangles) {
  std::set<std::pair<int, int>> open;
  for (const auto& uses : EdgeUses(triangles)) {
    if (uses.size() != 1) continue;
    open.emplace(TargetOf(triangles, uses[0]), OriginOf(triangles, uses[0]));
  }
  std::vector<BorderLoop> loops;
  while (!open.empty()) {
    // Walk on until a point is reached again; the walk since then is a loop.
    BorderLoop walk = {open.begin()->first};
    while (!walk.empty()) {
      const auto edge = open.lower_bound({walk.back(), -1});
      if (edge == open.end() || edge->first != walk.back()) break;
      const int next = edge->second;
      open.erase(edge);
      const auto again = std::find(walk.begin(), walk.end(), next);
      if (again == walk.end()) {
        walk.push_back(next);
        continue;
      }
      loops.emplace_back(again, walk.end());
      walk.erase(again + 1, walk.end());
    }
  }
  return loops;
}

double LoopLength(const BorderLoop& loop, const Points& points) {
  double length = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    length +=
        (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
  }
  return length;
}

bool HoleLimits::IsValid(std::string* error) const {
  const auto fail = [error](const std::string& field, auto value) {
    return InvalidOption("HoleLimits::" + field, value, "0 or above", error);
  };
  if (!(max_perimeter >= 0)) return fail("max_perimeter", max_perimeter);
  if (!(max_slit_ratio >= 0)) return fail("max_slit_ratio", max_slit_ratio);
  if (face_edges < 0) return fail("face_edges", face_edges);
  if (max_edges < 0) return fail("max_edges", max_edges);
  return true;
}

Fillings FillHoles(const HoleLimits& limits, TriangleSoup* soup) {
  std::string error;
  CHECK(limits.IsValid(&error)) << error;
  Fillings fillings;
  const auto loops = FindBorderLoops(soup->triangles);
  if (loops.empty()) return fillings;
  Edges edges = AllEdges(soup->triangles);
  for (const BorderLoop& loop : loops) {
    if (static_cast<int>(loop.size()) > limits.max_edges) continue;
    const int old_points = static_cast<int>(soup->points.rows());
    const Triangles patch = FillLoop(loop, edges, &soup->points);
    const double length = LoopLength(loop, soup->points);
    const double area = SurfaceArea(soup->points, patch);
    const bool is_small = length <= limits.max_perimeter ||
                          area <= limits.max_slit_ratio * length * length;
    const bool is_face = static_cast<int>(loop.size()) <= limits.face_edges;
    if (!is_small && !is_face) {
      soup->points.conservativeResize(old_points, 3);
      continue;
    }
    Append(patch, &soup->triangles);
    edges.merge(AllEdges(patch));
    ++fillings.holes;
    fillings.missing_faces += !is_small;
    fillings.triangles += static_cast<int>(patch.rows());
    fillings.points += static_cast<int>(soup->points.rows()) - old_points;
    fillings.area += area;
    fillings.longest = std::max(fillings.longest, length);
  }
  return fillings;
}

}  // namespace musclewarp
