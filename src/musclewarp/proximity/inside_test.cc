// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/inside_test.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "musclewarp/mesh/connectivity.h"

namespace musclewarp {
namespace {

constexpr int kMaxRays = 4;

// The sides of a cell. A new array holds zeros, so kUnknownCell must be zero.
constexpr char kUnknownCell = 0;
constexpr char kOutsideCell = 1;
constexpr char kInsideCell = 2;

// The generator of Steele, Lea and Flood 2014, "Fast Splittable Pseudorandom
// Number Generators". Distributions of the standard library are not used, since
// they differ between implementations.
std::uint64_t SplitMix(std::uint64_t state) {
  state += 0x9E3779B97F4A7C15u;
  state = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9u;
  state = (state ^ (state >> 27)) * 0x94D049BB133111EBu;
  return state ^ (state >> 31);
}

// Returns a direction towards the nearest side of the box, so that the ray is
// short. It is never along an axis, in which many meshes have edges.
Eigen::RowVector3d RandomDirection(const Eigen::RowVector3d& point,
                                   const Box3& box,
                                   unsigned seed,
                                   int attempt) {
  Eigen::RowVector3d direction;
  int nearest = 0;
  double distance = INFINITY;
  std::uint64_t state = (static_cast<std::uint64_t>(seed) << 8) + attempt;
  for (int k = 0; k < 3; ++k) {
    state = SplitMix(state);
    const double random = static_cast<double>(state >> 11) * 0x1p-53;
    const double below = point[k] - box.lower[k];
    const double above = box.upper[k] - point[k];
    direction[k] = (below < above ? -0.3 : 0.3) * (0.1 + random);
    if (std::min(below, above) < distance) {
      distance = std::min(below, above);
      nearest = k;
    }
  }
  direction[nearest] = direction[nearest] < 0 ? -1 : 1;
  return direction;
}

bool HasEvenEdges(const Triangles& triangles) {
  const EdgeUses edges(triangles);
  return std::all_of(edges.begin(), edges.end(), [](const auto& uses) {
    return uses.size() % 2 == 0;
  });
}

}  // namespace

InsideTest::InsideTest(const Points& points,
                       const Triangles& triangles,
                       unsigned seed)
    : soup_{points, triangles},
      grid_(points, triangles),
      seed_(seed),
      is_closed_(HasEvenEdges(triangles)),
      arbiter_(std::make_unique<Arbiter>()),
      cell_sides_(grid_.num_cells()) {}

void InsideTest::Refit(const Points& points) {
  soup_.points = points;
  grid_ = TriangleGrid(points, soup_.triangles);
  arbiter_ = std::make_unique<Arbiter>();
  cell_sides_ = std::vector<std::atomic<char>>(grid_.num_cells());
}

bool InsideTest::Contains(const Eigen::RowVector3d& point) const {
  if (!grid_.BoxContains(point)) return false;
  if (!is_closed_) return WindingContains(point);
  const int cell = grid_.EmptyCell(point);
  if (cell < 0) return RayContains(point);
  char side = cell_sides_[cell].load(std::memory_order_relaxed);
  if (side == kUnknownCell) {
    side = RayContains(point) ? kInsideCell : kOutsideCell;
    cell_sides_[cell].store(side, std::memory_order_relaxed);
  }
  return side == kInsideCell;
}

bool InsideTest::RayContains(const Eigen::RowVector3d& point) const {
  for (int attempt = 0; attempt < kMaxRays; ++attempt) {
    switch (grid_.CountCrossings(
        point, RandomDirection(point, grid_.box(), seed_, attempt))) {
      case RayParity::kEven:
        return false;
      case RayParity::kOdd:
        return true;
      case RayParity::kOnSurface:
        return false;
      case RayParity::kUndecided:
        break;
    }
  }
  return WindingContains(point);
}

bool InsideTest::WindingContains(const Eigen::RowVector3d& point) const {
  std::call_once(arbiter_->once, [this] {
    arbiter_->mesh = std::make_unique<SearchableMesh>(soup_);
  });
  return arbiter_->mesh->winding().IsInside(point);
}

}  // namespace musclewarp
