// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/own_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr double kLimit = 3;  // mm: nearer surfaces only

// Negative inside. Exact up to `limit` outside; anywhere inside.
double SignedDistance(const SearchableMesh& mesh,
                      const RowVector3d& p,
                      double limit) {
  const bool is_inside =
      mesh.bvh().box().Contains(p) && mesh.winding().IsInside(p);
  const double distance =
      mesh.bvh()
          .ClosestPoint(
              p, is_inside ? std::numeric_limits<double>::infinity() : limit)
          .distance;
  return is_inside ? -distance : std::min(distance, limit);
}

}  // namespace

// Cells by their centres; x runs fastest.
struct OwnRegion::Grid {
  RowVector3d origin;
  double cell;
  std::array<int, 3> size;
  std::vector<int>
      nearest;  // by cell: the nearest cell of the main part, or -1

  int count() const { return size[0] * size[1] * size[2]; }
  RowVector3d Centre(int index) const {
    return origin + cell * RowVector3d(index % size[0],
                                       index / size[0] % size[1],
                                       index / (size[0] * size[1]));
  }
  int IndexOf(const RowVector3d& p) const {
    std::array<int, 3> at;
    for (int k = 0; k < 3; ++k) {
      at[k] =
          std::clamp(static_cast<int>(std::lround((p[k] - origin[k]) / cell)),
                     0,
                     size[k] - 1);
    }
    return (at[2] * size[1] + at[1]) * size[0] + at[0];
  }
  template <typename Visit>
  void ForEachNeighbour(int index, const Visit& visit) const {
    const int x = index % size[0];
    const int y = index / size[0] % size[1];
    const int z = index / (size[0] * size[1]);
    if (x > 0) visit(index - 1);
    if (x + 1 < size[0]) visit(index + 1);
    if (y > 0) visit(index - size[0]);
    if (y + 1 < size[1]) visit(index + size[0]);
    if (z > 0) visit(index - size[0] * size[1]);
    if (z + 1 < size[2]) visit(index + size[0] * size[1]);
  }
};

OwnRegion::OwnRegion(const OwnRegionOptions& options,
                     const SearchableMesh& muscle,
                     std::vector<const SearchableMesh*> other_muscles,
                     std::vector<const SearchableMesh*> bones)
    : options_(options),
      muscle_(muscle),
      other_muscles_(std::move(other_muscles)),
      bones_(std::move(bones)) {}

double OwnRegion::Excess(const RowVector3d& p) const {
  double excess = -kLimit;
  for (const SearchableMesh* bone : bones_) {
    excess = std::max(excess,
                      options_.margin / 2 - SignedDistance(*bone, p, kLimit));
  }
  double own = 0;
  bool is_own_known = false;
  for (const SearchableMesh* other : other_muscles_) {
    const double theirs = SignedDistance(*other, p, kLimit);
    if (theirs >= kLimit) continue;
    if (!is_own_known) {
      own = SignedDistance(muscle_, p, 4 * kLimit);
      is_own_known = true;
    }
    excess = std::max(excess, (own - theirs + options_.margin) / 2);
  }
  return excess;
}

RowVector3d OwnRegion::Inward(const RowVector3d& p) const {
  constexpr double kStep = 0.1;
  RowVector3d gradient;
  for (int k = 0; k < 3; ++k) {
    RowVector3d step = RowVector3d::Zero();
    step[k] = kStep;
    gradient[k] = Excess(p + step) - Excess(p - step);
  }
  const double norm = gradient.norm();
  return norm > 1e-6 ? RowVector3d(-gradient / norm) : RowVector3d::Zero();
}

bool OwnRegion::IsFree(const RowVector3d& a,
                       double excess_a,
                       const RowVector3d& b,
                       double excess_b) const {
  constexpr double kThinnest = 0.2;  // mm
  const double length = (b - a).norm();
  // The excess grows by no more than the way.
  if (excess_a + excess_b <= -length || length < kThinnest) return true;
  const RowVector3d middle = (a + b) / 2;
  const double excess = Excess(middle);
  return excess <= 0 && IsFree(a, excess_a, middle, excess) &&
         IsFree(middle, excess, b, excess_b);
}

OwnRegion::Grid OwnRegion::MainPart() const {
  Grid grid;
  grid.cell = options_.cell;
  const Box3& box = muscle_.bvh().box();
  for (int k = 0; k < 3; ++k) {
    grid.origin[k] = box.lower[k] - 2 * grid.cell;
    grid.size[k] =
        static_cast<int>(std::ceil((box.upper[k] - box.lower[k]) / grid.cell)) +
        5;
  }
  const int count = grid.count();
  // What is thinner than a cell hangs together by the cells beside it.
  std::vector<double> excess(count, 1);
#pragma omp parallel for schedule(dynamic, 256)
  for (int i = 0; i < count; ++i) {
    const RowVector3d p = grid.Centre(i);
    if (muscle_.winding().IsInside(p) ||
        muscle_.bvh().ClosestPoint(p, grid.cell).triangle >= 0) {
      excess[i] = Excess(p);
    }
  }
  const auto is_free = [&](int i) { return excess[i] <= 0; };
  const auto are_connected = [&](int i, int j) {
    return IsFree(grid.Centre(i), excess[i], grid.Centre(j), excess[j]);
  };
  std::vector<int> part(count, -1);
  std::vector<int> part_size;
  for (int i = 0; i < count; ++i) {
    if (!is_free(i) || part[i] >= 0) continue;
    const int number = static_cast<int>(part_size.size());
    std::vector<int> front = {i};
    part[i] = number;
    int size = 0;
    while (!front.empty()) {
      const int at = front.back();
      front.pop_back();
      ++size;
      grid.ForEachNeighbour(at, [&](int next) {
        if (!is_free(next) || part[next] >= 0) return;
        if (!are_connected(at, next)) return;
        part[next] = number;
        front.push_back(next);
      });
    }
    part_size.push_back(size);
  }
  grid.nearest.assign(count, -1);
  if (part_size.empty()) return grid;
  const int main = static_cast<int>(
      std::max_element(part_size.begin(), part_size.end()) - part_size.begin());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distance(count, std::numeric_limits<double>::infinity());
  for (int i = 0; i < count; ++i) {
    if (part[i] != main) continue;
    grid.nearest[i] = i;
    distance[i] = 0;
    queue.emplace(0, i);
  }
  while (!queue.empty()) {
    const auto [d, at] = queue.top();
    queue.pop();
    if (d > distance[at]) continue;
    grid.ForEachNeighbour(at, [&](int next) {
      const double through =
          (grid.Centre(next) - grid.Centre(grid.nearest[at])).norm();
      if (through < distance[next] - 1e-9) {
        distance[next] = through;
        grid.nearest[next] = grid.nearest[at];
        queue.emplace(through, next);
      }
    });
  }
  return grid;
}

Points OwnRegion::Project(const Points& points) const {
  const Grid grid = MainPart();
  Points projected = points;
#pragma omp parallel for schedule(dynamic, 64)
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const RowVector3d p = points.row(v);
    const int nearest = grid.nearest[grid.IndexOf(p)];
    if (nearest < 0) continue;
    const RowVector3d q = grid.Centre(nearest);
    const double excess_p = Excess(p);
    const double excess_q = Excess(q);
    if (excess_p <= 0 && IsFree(q, excess_q, p, excess_p)) continue;
    // From the main part towards p, by as much as is free around, until the
    // border of the region.
    constexpr double kNear = 1e-4;  // mm
    const double way = (p - q).norm();
    double at = 0;
    for (double room = -excess_q; room > kNear && at < way;) {
      at = std::min(way, at + room);
      room = -Excess(q + at / way * (p - q));
    }
    projected.row(v) = q + at / way * (p - q);
  }
  return projected;
}

}  // namespace musclewarp
