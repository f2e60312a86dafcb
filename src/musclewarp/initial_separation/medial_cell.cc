// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/medial_cell.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <set>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/option_check.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

}  // namespace

// A grid of voxels, represented by their centres; x changes fastest.
struct MedialCell::VoxelGrid {
  RowVector3d origin;
  double voxel_size;
  std::array<int, 3> size;

  // Voxels are sampled by cubes of so many a side.
  static constexpr int kBlock = 4;

  // By voxel: the signed distance of its centre to the cell, or a positive
  // number if it is more than a voxel outside the muscle.
  std::vector<double> distance;

  // By voxel: the nearest voxel of the main part, or -1.
  std::vector<int> nearest;

  VoxelGrid(const Box3& box, double voxel) : voxel_size(voxel) {
    for (int k = 0; k < 3; ++k) {
      origin[k] = box.lower[k] - 2 * voxel;
      size[k] =
          static_cast<int>(std::ceil((box.upper[k] - box.lower[k]) / voxel)) +
          5;
    }
  }

  int count() const { return size[0] * size[1] * size[2]; }
  std::array<int, 3> num_blocks() const {
    return {(size[0] + kBlock - 1) / kBlock,
            (size[1] + kBlock - 1) / kBlock,
            (size[2] + kBlock - 1) / kBlock};
  }
  std::array<int, 3> PlaceOf(int index) const {
    return {index % size[0],
            index / size[0] % size[1],
            index / (size[0] * size[1])};
  }
  RowVector3d Centre(const std::array<int, 3>& at) const {
    return origin + voxel_size * RowVector3d(at[0], at[1], at[2]);
  }
  RowVector3d Centre(int index) const { return Centre(PlaceOf(index)); }
  int IndexOf(const RowVector3d& p) const {
    std::array<int, 3> at;
    for (int k = 0; k < 3; ++k) {
      at[k] = std::clamp(
          static_cast<int>(std::lround((p[k] - origin[k]) / voxel_size)),
          0,
          size[k] - 1);
    }
    return (at[2] * size[1] + at[1]) * size[0] + at[0];
  }
  // Calls visit(index) for the voxels of the block from `first` on.
  template <typename Visit>
  void ForEachIn(const std::array<int, 3>& first, const Visit& visit) const {
    const auto end = [&](int k) {
      return std::min(first[k] + kBlock, size[k]);
    };
    for (int z = first[2]; z < end(2); ++z) {
      for (int y = first[1]; y < end(1); ++y) {
        for (int x = first[0]; x < end(0); ++x) {
          visit((z * size[1] + y) * size[0] + x);
        }
      }
    }
  }
  // Calls visit(index, place) for each neighbour of a voxel.
  template <typename Visit>
  void ForEachNeighbour(int index, const Visit& visit) const {
    std::array<int, 3> at = PlaceOf(index);
    const std::array<int, 3> strides = {1, size[0], size[0] * size[1]};
    for (int k = 0; k < 3; ++k) {
      if (at[k] > 0) {
        --at[k];
        visit(index - strides[k], at);
        ++at[k];
      }
      if (at[k] + 1 < size[k]) {
        ++at[k];
        visit(index + strides[k], at);
        --at[k];
      }
    }
  }

  // Returns the largest connected set of free voxels, in ascending order, where
  // two neighbours are connected if are_connected(i, j).
  template <typename IsFree, typename AreConnected>
  std::vector<int> LargestPart(const IsFree& is_free,
                               const AreConnected& are_connected) const {
    std::vector<char> is_visited(count(), false);
    std::vector<int> largest;
    for (int i = 0; i < count(); ++i) {
      if (!is_free(i) || is_visited[i]) continue;
      std::vector<int> part = {i};
      is_visited[i] = true;
      std::vector<int> front = {i};
      while (!front.empty()) {
        const int at = front.back();
        front.pop_back();
        ForEachNeighbour(at, [&](int next, const auto& /*place*/) {
          if (!is_free(next) || is_visited[next]) return;
          if (!are_connected(at, next)) return;
          is_visited[next] = true;
          part.push_back(next);
          front.push_back(next);
        });
      }
      if (part.size() > largest.size()) largest = std::move(part);
    }
    std::sort(largest.begin(), largest.end());
    return largest;
  }

  // Sets `nearest`, outwards from the voxels `part`, until it is known for all
  // voxels in `wanted`.
  void SpreadFrom(const std::vector<int>& part, std::set<int> wanted) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<double> way(count(), kInfinity);
    nearest.assign(count(), -1);
    for (const int i : part) {
      nearest[i] = i;
      way[i] = 0;
    }
    for (const int i : part) {
      wanted.erase(i);
      bool is_at_border = false;
      ForEachNeighbour(i, [&](int next, const auto& /*place*/) {
        is_at_border |= way[next] > 0;
      });
      if (is_at_border) queue.emplace(0, i);
    }
    while (!queue.empty() && !wanted.empty()) {
      const auto [d, at] = queue.top();
      queue.pop();
      if (d > way[at]) continue;
      wanted.erase(at);
      const int source = nearest[at];
      const RowVector3d centre = Centre(source);
      ForEachNeighbour(at, [&](int next, const auto& place) {
        const double through = (Centre(place) - centre).norm();
        if (through < way[next] - 1e-9) {
          way[next] = through;
          nearest[next] = source;
          queue.emplace(through, next);
        }
      });
    }
  }
};

bool MedialCellOptions::IsValid(std::string* error) const {
  return OptionCheck("MedialCellOptions", error)
      .IsAtLeast("margin", margin, 0)
      .IsAbove("voxel_size", voxel_size, 0)
      .IsAbove("range", range, margin)
      .IsAbove("thinnest_wall", thinnest_wall, 0)
      .is_valid();
}

MedialCell::MedialCell(const MedialCellOptions& options,
                       const SolidDistance& muscle,
                       std::vector<const SolidDistance*> other_muscles,
                       std::vector<const SolidDistance*> bones)
    : options_(options),
      muscle_(muscle),
      other_muscles_(std::move(other_muscles)),
      bones_(std::move(bones)) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
}

double MedialCell::SignedDistance(const RowVector3d& p) const {
  const double range = options_.range;
  double distance = -range;
  for (const SolidDistance* bone : bones_) {
    distance = std::max(distance, options_.margin / 2 - bone->At(p, range));
  }
  double own = 0;
  bool is_own_known = false;
  for (const SolidDistance* other : other_muscles_) {
    const double theirs = other->At(p, range);
    if (theirs >= range) continue;
    if (!is_own_known) {
      own = muscle_.At(p, 4 * range);
      is_own_known = true;
    }
    distance = std::max(distance, (own - theirs + options_.margin) / 2);
  }
  return distance;
}

double MedialCell::DistanceDownTo(double depth, const RowVector3d& p) const {
  const double margin = options_.margin;
  double distance = -depth;
  for (const SolidDistance* bone : bones_) {
    const double limit = std::min(options_.range, depth + margin / 2);
    distance = std::max(distance, margin / 2 - bone->At(p, limit));
  }
  // Deep in the muscle, only muscles that extend as deep bound the cell.
  const double limit = std::clamp(
      muscle_.UpperBound(p) + margin + 2 * depth, 0.0, options_.range);
  double own = 0;
  bool is_own_known = false;
  for (const SolidDistance* other : other_muscles_) {
    const double theirs = other->At(p, limit);
    if (theirs >= limit) continue;
    if (!is_own_known) {
      own = muscle_.At(p, 4 * options_.range);
      is_own_known = true;
    }
    distance = std::max(distance, (own - theirs + margin) / 2);
  }
  return distance;
}

double MedialCell::RegionDistance(const RowVector3d& p) const {
  return RegionDistance(p, muscle_.At(p, kInfinity));
}

double MedialCell::RegionDistance(const RowVector3d& p, double own) const {
  // Farther outside, the muscle's own distance makes the sum with other muscles
  // large enough.
  return own >= options_.range + options_.margin
             ? own
             : std::max(own, SignedDistance(p));
}

RowVector3d MedialCell::Inward(const RowVector3d& p) const {
  constexpr double kStep = 0.1;  // mm, of the central differences
  RowVector3d gradient;
  for (int k = 0; k < 3; ++k) {
    RowVector3d step = RowVector3d::Zero();
    step[k] = kStep;
    gradient[k] = SignedDistance(p + step) - SignedDistance(p - step);
  }
  const double norm = gradient.norm();
  return norm > 1e-6 ? RowVector3d(-gradient / norm) : RowVector3d::Zero();
}

bool MedialCell::IsPathFree(const RowVector3d& a,
                            double distance_a,
                            const RowVector3d& b,
                            double distance_b) const {
  const double length = (b - a).norm();
  // The signed distance grows at most by the length of the path.
  if (distance_a + distance_b <= -length || length < options_.thinnest_wall) {
    return true;
  }
  const RowVector3d middle = (a + b) / 2;
  const double distance = SignedDistance(middle);
  return distance <= 0 && IsPathFree(a, distance_a, middle, distance) &&
         IsPathFree(middle, distance, b, distance_b);
}

bool MedialCell::IsDeepAround(const RowVector3d& p,
                              double radius,
                              double depth) const {
  const double deepest = depth + radius;
  const double own = muscle_.UpperBound(p);
  if (own + radius >= 0) return false;
  const double to_bones = deepest + options_.margin / 2;
  const double to_others = std::max(0.0, own + options_.margin + 2 * deepest);
  const auto is_beyond = [&](double distance) {
    return [&p, distance](const SolidDistance* solid) {
      return solid->At(p, distance) >= distance;
    };
  };
  return std::all_of(bones_.begin(), bones_.end(), is_beyond(to_bones)) &&
         std::all_of(other_muscles_.begin(),
                     other_muscles_.end(),
                     is_beyond(to_others));
}

MedialCell::VoxelGrid MedialCell::SampledVoxels() const {
  VoxelGrid grid(muscle_.mesh().bvh().box(), options_.voxel_size);
  // Voxels next to the muscle connect parts of it thinner than a voxel.
  grid.distance.assign(grid.count(), 1);
  const double voxel = grid.voxel_size;
  // The path to a neighbour is free if the voxel is deeper than its length.
  const double depth = 1.01 * voxel;
  const std::array<int, 3> blocks = grid.num_blocks();
  constexpr int kBlock = VoxelGrid::kBlock;
  // To the farthest voxel of a block, and more than rounding.
  const double radius = 1.001 * std::sqrt(3.0) / 2 * (kBlock - 1) * voxel;
#pragma omp parallel for schedule(dynamic, 4)
  for (int b = 0; b < blocks[0] * blocks[1] * blocks[2]; ++b) {
    const std::array<int, 3> first = {kBlock * (b % blocks[0]),
                                      kBlock * (b / blocks[0] % blocks[1]),
                                      kBlock * (b / (blocks[0] * blocks[1]))};
    const RowVector3d middle =
        grid.Centre(first) + RowVector3d::Constant((kBlock - 1) / 2.0 * voxel);
    if (muscle_.At(middle, voxel + radius) >= voxel + radius) continue;
    const bool is_deep = IsDeepAround(middle, radius, depth);
    grid.ForEachIn(first, [&](int i) {
      const RowVector3d p = grid.Centre(i);
      if (is_deep) {
        grid.distance[i] = -depth;
      } else if (muscle_.UpperBound(p) < voxel ||
                 muscle_.At(p, voxel) < voxel) {
        grid.distance[i] = DistanceDownTo(depth, p);
      }
    });
  }
  return grid;
}

void MedialCell::FindMainPart(const Points& points, VoxelGrid* grid) const {
  const std::vector<double>& distance = grid->distance;
  std::set<int> wanted;
  for (const auto p : points.rowwise()) wanted.insert(grid->IndexOf(p));
  grid->SpreadFrom(grid->LargestPart([&](int i) { return distance[i] <= 0; },
                                     [&](int i, int j) {
                                       return IsPathFree(grid->Centre(i),
                                                         distance[i],
                                                         grid->Centre(j),
                                                         distance[j]);
                                     }),
                   std::move(wanted));
}

RowVector3d MedialCell::Border(const RowVector3d& q,
                               double distance_q,
                               const RowVector3d& p) const {
  // Sphere tracing: the path is free for the length of the signed distance.
  constexpr double kTolerance = 1e-4;  // mm
  const double way = (p - q).norm();
  double at = 0;
  for (double room = -distance_q; room > kTolerance && at < way;) {
    at = std::min(way, at + room);
    room = -SignedDistance(q + at / way * (p - q));
  }
  return q + at / way * (p - q);
}

Points MedialCell::Project(const Points& points) const {
  return Project({this}, {&points})[0];
}

std::vector<Points> MedialCell::Project(
    const std::vector<const MedialCell*>& cells,
    const std::vector<const Points*>& points) {
  CHECK_EQ(cells.size(), points.size());
  std::vector<VoxelGrid> grids;
  for (const MedialCell* cell : cells) grids.push_back(cell->SampledVoxels());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < cells.size(); ++i) {
    cells[i]->FindMainPart(*points[i], &grids[i]);
  }
  std::vector<Points> projected;
  for (size_t i = 0; i < cells.size(); ++i) {
    projected.push_back(cells[i]->Project(*points[i], grids[i]));
  }
  return projected;
}

Points MedialCell::Project(const Points& points, const VoxelGrid& grid) const {
  Points projected = points;
#pragma omp parallel for schedule(dynamic, 64)
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const RowVector3d p = points.row(v);
    const int nearest = grid.nearest[grid.IndexOf(p)];
    if (nearest < 0) continue;
    const RowVector3d q = grid.Centre(nearest);
    const double distance_p = SignedDistance(p);
    const double distance_q = SignedDistance(q);
    if (distance_p <= 0 && IsPathFree(q, distance_q, p, distance_p)) continue;
    projected.row(v) = Border(q, distance_q, p);
  }
  return projected;
}

}  // namespace musclewarp
