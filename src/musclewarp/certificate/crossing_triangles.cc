// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/crossing_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "musclewarp/geometry/triangle_intersection.h"

namespace musclewarp {
namespace {

using Index3 = std::array<int, 3>;

// A box around a triangle, in single precision and rounded outward.
struct RoundedBox {
  std::array<float, 3> lower, upper;

  bool Overlaps(const RoundedBox& other) const {
    return lower[0] <= other.upper[0] && other.lower[0] <= upper[0] &&
           lower[1] <= other.upper[1] && other.lower[1] <= upper[1] &&
           lower[2] <= other.upper[2] && other.lower[2] <= upper[2];
  }
};

struct Entry {
  RoundedBox box;
  Corners corners;
  int mesh, triangle;
};

Entry EntryOf(const SurfaceView& surface, int mesh, Eigen::Index triangle) {
  Entry entry;
  for (int k = 0; k < 3; ++k) {
    entry.corners.row(k) =
        surface.points->row((*surface.triangles)(triangle, k));
  }
  // A float is off by 2^-24 of its size at most.
  constexpr float kRounding = 0x1p-22f;
  for (int k = 0; k < 3; ++k) {
    const auto lower = static_cast<float>(entry.corners.col(k).minCoeff());
    const auto upper = static_cast<float>(entry.corners.col(k).maxCoeff());
    constexpr float kLeast = std::numeric_limits<float>::min();
    entry.box.lower[k] = lower - (kRounding * std::abs(lower) + kLeast);
    entry.box.upper[k] = upper + (kRounding * std::abs(upper) + kLeast);
  }
  entry.mesh = mesh;
  entry.triangle = static_cast<int>(triangle);
  return entry;
}

std::vector<Entry> EntriesOf(const std::vector<SurfaceView>& surfaces) {
  std::vector<Entry> entries;
  for (size_t mesh = 0; mesh < surfaces.size(); ++mesh) {
    const size_t first = entries.size();
    entries.resize(first + surfaces[mesh].triangles->rows());
#pragma omp parallel for schedule(static)
    for (Eigen::Index f = 0; f < surfaces[mesh].triangles->rows(); ++f) {
      entries[first + f] = EntryOf(surfaces[mesh], static_cast<int>(mesh), f);
    }
  }
  return entries;
}

// The triangles of the muscles by the cells that their boxes touch.
class Grid {
 public:
  explicit Grid(const std::vector<Entry>& entries) : entries_(entries) {
    if (entries.empty()) return;
    Eigen::Array3d lower = Eigen::Array3d::Constant(1e30), upper = -lower;
    double size = 0;
    for (const Entry& entry : entries) {
      double longest = 0;
      for (int k = 0; k < 3; ++k) {
        lower[k] = std::min<double>(lower[k], entry.box.lower[k]);
        upper[k] = std::max<double>(upper[k], entry.box.upper[k]);
        longest =
            std::max<double>(longest, entry.box.upper[k] - entry.box.lower[k]);
      }
      size += longest;
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
    per_cell_ = 1 / cell_;
    starts_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
    for (const Entry& entry : entries) {
      ForEachCell(entry.box, [&](int cell) { ++starts_[cell + 1]; });
    }
    for (size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    items_.resize(starts_.back());
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    for (size_t i = 0; i < entries.size(); ++i) {
      ForEachCell(entries[i].box, [&](int cell) {
        items_[next[cell]++] = {entries[i].box, static_cast<int>(i)};
      });
    }
  }

  Eigen::Index size() const {
    return static_cast<Eigen::Index>(entries_.size());
  }

  // Calls visit(entry) for the first `count` of the muscles' triangles whose
  // box overlaps that of `entry`, each once.
  template <typename Visit>
  void ForEachOverlap(const Entry& entry,
                      Eigen::Index count,
                      const Visit& visit) const {
    if (entries_.empty()) return;
    const Index3 first = CellOf(entry.box.lower);
    ForEachCell(entry.box, [&](int cell) {
      const Index3 at = {cell % counts_[0],
                         cell / counts_[0] % counts_[1],
                         cell / (counts_[0] * counts_[1])};
      for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        if (items_[i].entry >= count) break;  // they ascend in a cell
        if (!entry.box.Overlaps(items_[i].box)) continue;
        // Of the cells that both touch, in the first one only.
        const Index3 other_first = CellOf(items_[i].box.lower);
        bool is_first = true;
        for (int k = 0; k < 3; ++k) {
          is_first &= at[k] == std::max(first[k], other_first[k]);
        }
        if (is_first) visit(entries_[items_[i].entry]);
      }
    });
  }

 private:
  struct Item {
    RoundedBox box;
    int entry;
  };

  Index3 CellOf(const std::array<float, 3>& p) const {
    Index3 at;
    for (int k = 0; k < 3; ++k) {
      const double cell = std::floor((p[k] - origin_[k]) * per_cell_);
      at[k] = static_cast<int>(std::clamp(cell, 0.0, counts_[k] - 1.0));
    }
    return at;
  }

  // Nothing for boxes beside the grid.
  template <typename Visit>
  void ForEachCell(const RoundedBox& box, const Visit& visit) const {
    for (int k = 0; k < 3; ++k) {
      if (box.upper[k] < origin_[k] ||
          box.lower[k] > origin_[k] + cell_ * counts_[k]) {
        return;
      }
    }
    const Index3 first = CellOf(box.lower), last = CellOf(box.upper);
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
  double cell_ = 1, per_cell_ = 1;  // edge, mm, and its inverse
  Index3 counts_ = {1, 1, 1};
  // The items of cell c are items_[starts_[c]] to items_[starts_[c + 1]].
  std::vector<int> starts_;
  std::vector<Item> items_;
};

// Adds the pairs that the entries of `entry_of` form with those of the muscles;
// if they are those of the muscles themselves, with the entries before them.
template <typename EntryOf>
void AddPairs(const Grid& grid,
              Eigen::Index count,
              bool are_muscles,
              const EntryOf& entry_of,
              std::vector<CrossingPair>* pairs) {
#pragma omp parallel
  {
    std::vector<CrossingPair> found;
#pragma omp for schedule(dynamic, 1024) nowait
    for (Eigen::Index i = 0; i < count; ++i) {
      const Entry& entry = entry_of(i);
      const Eigen::Index others = are_muscles ? i : grid.size();
      grid.ForEachOverlap(entry, others, [&](const Entry& other) {
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
  const std::vector<Entry> entries = EntriesOf(muscles);
  const Grid grid(entries);
  std::vector<CrossingPair> pairs;
  AddPairs(
      grid,
      static_cast<Eigen::Index>(entries.size()),
      /*are_muscles=*/true,
      [&](Eigen::Index i) -> const Entry& { return entries[i]; },
      &pairs);
  for (size_t b = 0; b < bones.size(); ++b) {
    AddPairs(
        grid,
        bones[b].triangles->rows(),
        /*are_muscles=*/false,
        [&](Eigen::Index i) {
          return EntryOf(bones[b], static_cast<int>(muscles.size() + b), i);
        },
        &pairs);
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
