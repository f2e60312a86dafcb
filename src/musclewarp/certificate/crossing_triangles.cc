// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/crossing_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "musclewarp/geometry/triangle_intersection.h"

namespace musclewarp {
namespace {

using Index3 = std::array<int, 3>;

struct Entry {
  Eigen::Array3d lower, upper;
  Corners corners;
  int mesh, triangle;

  bool Overlaps(const Entry& other) const {
    return (lower <= other.upper).all() && (other.lower <= upper).all();
  }
};

std::vector<Entry> EntriesOf(const SurfaceView& surface, int mesh) {
  std::vector<Entry> entries(surface.triangles->rows());
  for (Eigen::Index f = 0; f < surface.triangles->rows(); ++f) {
    Entry& entry = entries[f];
    for (int k = 0; k < 3; ++k) {
      entry.corners.row(k) = surface.points->row((*surface.triangles)(f, k));
    }
    entry.lower = entry.corners.colwise().minCoeff().transpose();
    entry.upper = entry.corners.colwise().maxCoeff().transpose();
    entry.mesh = mesh;
    entry.triangle = static_cast<int>(f);
  }
  return entries;
}

// The triangles of the muscles by the cells that their boxes touch.
class Grid {
 public:
  explicit Grid(const std::vector<Entry>& entries) : entries_(entries) {
    if (entries.empty()) return;
    Eigen::Array3d lower = entries[0].lower, upper = entries[0].upper;
    double size = 0;
    for (const Entry& entry : entries) {
      lower = lower.min(entry.lower);
      upper = upper.max(entry.upper);
      size += (entry.upper - entry.lower).maxCoeff();
    }
    origin_ = lower;
    // Cells about as large as a triangle, and no more of them than four for
    // each.
    cell_ = std::max(size / static_cast<double>(entries.size()), 1e-9);
    const double most = 4.0 * static_cast<double>(entries.size()) + 64;
    for (;; cell_ *= 1.3) {
      const Eigen::Array3d counts = ((upper - lower) / cell_).floor() + 1;
      if (counts.prod() > most) continue;
      for (int k = 0; k < 3; ++k) counts_[k] = static_cast<int>(counts[k]);
      break;
    }
    starts_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
    for (const Entry& entry : entries) {
      ForEachCell(entry, [&](int cell) { ++starts_[cell + 1]; });
    }
    for (size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    items_.resize(starts_.back());
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    for (size_t i = 0; i < entries.size(); ++i) {
      ForEachCell(entries[i], [&](int cell) {
        items_[next[cell]++] = static_cast<int>(i);
      });
    }
  }

  // Calls visit(entry) for the muscles' triangles whose box overlaps that of
  // `entry`, each once.
  template <typename Visit>
  void ForEachOverlap(const Entry& entry, const Visit& visit) const {
    if (entries_.empty()) return;
    const Index3 first = CellOf(entry.lower);
    ForEachCell(entry, [&](int cell) {
      const Index3 at = {cell % counts_[0],
                         cell / counts_[0] % counts_[1],
                         cell / (counts_[0] * counts_[1])};
      for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const Entry& other = entries_[items_[i]];
        if (!entry.Overlaps(other)) continue;
        // Of the cells that both touch, in the first one only.
        const Index3 other_first = CellOf(other.lower);
        bool is_first = true;
        for (int k = 0; k < 3; ++k) {
          is_first &= at[k] == std::max(first[k], other_first[k]);
        }
        if (is_first) visit(other);
      }
    });
  }

 private:
  Index3 CellOf(const Eigen::Array3d& p) const {
    Index3 at;
    for (int k = 0; k < 3; ++k) {
      const double cell = std::floor((p[k] - origin_[k]) / cell_);
      at[k] = static_cast<int>(std::clamp(cell, 0.0, counts_[k] - 1.0));
    }
    return at;
  }

  // Nothing for boxes beside the grid.
  template <typename Visit>
  void ForEachCell(const Entry& entry, const Visit& visit) const {
    for (int k = 0; k < 3; ++k) {
      if (entry.upper[k] < origin_[k] ||
          entry.lower[k] > origin_[k] + cell_ * counts_[k]) {
        return;
      }
    }
    const Index3 first = CellOf(entry.lower), last = CellOf(entry.upper);
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x) {
          visit((z * counts_[1] + y) * counts_[0] + x);
        }
      }
    }
  }

  const std::vector<Entry>& entries_;
  Eigen::Array3d origin_ = Eigen::Array3d::Zero();
  double cell_ = 1;  // edge, mm
  Index3 counts_ = {1, 1, 1};
  // Those of cell c are items_[starts_[c]] to items_[starts_[c + 1]].
  std::vector<int> starts_;
  std::vector<int> items_;  // of entries_
};

void AddPairs(const Grid& grid,
              const std::vector<Entry>& entries,
              bool are_muscles,
              std::vector<CrossingPair>* pairs) {
#pragma omp parallel
  {
    std::vector<CrossingPair> found;
#pragma omp for schedule(dynamic, 256) nowait
    for (size_t i = 0; i < entries.size(); ++i) {
      const Entry& entry = entries[i];
      grid.ForEachOverlap(entry, [&](const Entry& other) {
        if (are_muscles && std::tie(other.mesh, other.triangle) >=
                               std::tie(entry.mesh, entry.triangle)) {
          return;
        }
        const bool cross =
            entry.mesh == other.mesh
                ? TrianglesIntersectBeyondCommon(other.corners, entry.corners)
                : TrianglesIntersect(other.corners, entry.corners);
        if (!cross) return;
        found.push_back(
            {other.mesh, entry.mesh, other.triangle, entry.triangle});
      });
    }
#pragma omp critical
    pairs->insert(pairs->end(), found.begin(), found.end());
  }
}

}  // namespace

std::vector<CrossingPair> CrossingTriangles(
    const std::vector<SurfaceView>& muscles,
    const std::vector<SurfaceView>& bones) {
  std::vector<Entry> entries;
  int mesh = 0;
  for (const SurfaceView& muscle : muscles) {
    const std::vector<Entry> more = EntriesOf(muscle, mesh++);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  const Grid grid(entries);
  std::vector<CrossingPair> pairs;
  AddPairs(grid, entries, /*are_muscles=*/true, &pairs);
  for (const SurfaceView& bone : bones) {
    AddPairs(grid, EntriesOf(bone, mesh++), /*are_muscles=*/false, &pairs);
  }
  std::sort(pairs.begin(),
            pairs.end(),
            [](const CrossingPair& p, const CrossingPair& q) {
              return std::tie(p.a, p.b, p.f, p.g) <
                     std::tie(q.a, q.b, q.f, q.g);
            });
  return pairs;
}

}  // namespace musclewarp
