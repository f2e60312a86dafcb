// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/crossing_triangles.h"

#include <algorithm>
#include <tuple>

#include "musclewarp/certificate/box_grid.h"
#include "musclewarp/proximity/triangle_intersection.h"

namespace musclewarp {
namespace {

struct Entry {
  RoundedBox box;
  Corners corners;
  int mesh, triangle;
};

Entry EntryOf(const SurfaceView& surface, int mesh, Eigen::Index triangle) {
  Entry entry;
  entry.corners = CornersOf(*surface.points, surface.triangles->row(triangle));
  entry.box = RoundedBoxOf(entry.corners);
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

// The triangles of the muscles, by the cells that their boxes touch.
class MuscleTriangles {
 public:
  explicit MuscleTriangles(const std::vector<SurfaceView>& muscles)
      : entries_(EntriesOf(muscles)), grid_(BoxesOf(entries_)) {}

  Eigen::Index size() const { return grid_.size(); }
  const Entry& operator[](Eigen::Index i) const { return entries_[i]; }

  // Calls visit(entry) for those of the first `count` triangles whose box
  // overlaps that of `entry`, for each once.
  template <typename Visit>
  void ForEachOverlap(const Entry& entry,
                      Eigen::Index count,
                      const Visit& visit) const {
    grid_.ForEachOverlap(entry.box, count, [&](int i) { visit(entries_[i]); });
  }

 private:
  static std::vector<RoundedBox> BoxesOf(const std::vector<Entry>& entries) {
    std::vector<RoundedBox> boxes;
    boxes.reserve(entries.size());
    for (const Entry& entry : entries) boxes.push_back(entry.box);
    return boxes;
  }

  std::vector<Entry> entries_;
  BoxGrid grid_;
};

// By muscle: the vertices with proper stars, or nothing where rings are not
// known.
std::vector<std::vector<char>> ProperStarsOf(
    const std::vector<SurfaceView>& muscles) {
  std::vector<std::vector<char>> are_proper;
  for (const SurfaceView& muscle : muscles) {
    are_proper.emplace_back();
    if (!muscle.rings) continue;
    are_proper.back() = ProperStars(*muscle.rings, *muscle.points);
  }
  return are_proper;
}

// Adds the pairs that the entries of `entry_of` form with those of the muscles;
// if they are those of the muscles themselves, with the entries before them.
template <typename EntryOf, typename IsApart>
void AddPairs(const MuscleTriangles& all,
              Eigen::Index count,
              bool are_muscles,
              const EntryOf& entry_of,
              const IsApart& is_apart,
              std::vector<CrossingPair>* pairs) {
#pragma omp parallel
  {
    std::vector<CrossingPair> found;
#pragma omp for schedule(dynamic, 1024) nowait
    for (Eigen::Index i = 0; i < count; ++i) {
      const Entry& entry = entry_of(i);
      const Eigen::Index others = are_muscles ? i : all.size();
      all.ForEachOverlap(entry, others, [&](const Entry& other) {
        if (is_apart(entry, other)) return;
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
  const MuscleTriangles all(muscles);
  const std::vector<std::vector<char>> are_proper = ProperStarsOf(muscles);
  std::vector<CrossingPair> pairs;
  AddPairs(
      all,
      all.size(),
      /*are_muscles=*/true,
      [&](Eigen::Index i) -> const Entry& { return all[i]; },
      [&](const Entry& a, const Entry& b) {
        return a.mesh == b.mesh && !are_proper[a.mesh].empty() &&
               ShareProperStar(*muscles[a.mesh].triangles,
                               are_proper[a.mesh],
                               a.triangle,
                               b.triangle);
      },
      &pairs);
  for (size_t b = 0; b < bones.size(); ++b) {
    AddPairs(
        all,
        bones[b].triangles->rows(),
        /*are_muscles=*/false,
        [&](Eigen::Index i) {
          return EntryOf(bones[b], static_cast<int>(muscles.size() + b), i);
        },
        [](const Entry&, const Entry&) { return false; },
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
