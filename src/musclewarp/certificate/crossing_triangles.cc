// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/crossing_triangles.h"

#include <glog/logging.h>

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

Entry EntryOf(const BoxedMesh& boxed, int mesh, Eigen::Index triangle) {
  Entry entry;
  entry.corners = boxed.corners(triangle);
  entry.box = RoundedBoxOf(entry.corners);
  entry.mesh = mesh;
  entry.triangle = static_cast<int>(triangle);
  return entry;
}

std::vector<Entry> EntriesOf(const std::vector<BoxedMesh>& meshes,
                             size_t num_muscles) {
  std::vector<Entry> entries;
  for (size_t mesh = 0; mesh < num_muscles; ++mesh) {
    const size_t first = entries.size();
    entries.resize(first + meshes[mesh].num_triangles());
#pragma omp parallel for schedule(static)
    for (Eigen::Index f = 0; f < meshes[mesh].num_triangles(); ++f) {
      entries[first + f] = EntryOf(meshes[mesh], static_cast<int>(mesh), f);
    }
  }
  return entries;
}

// The triangles of the muscles, by the cells that their boxes touch.
class MuscleTriangles {
 public:
  MuscleTriangles(const std::vector<BoxedMesh>& meshes, size_t num_muscles)
      : entries_(EntriesOf(meshes, num_muscles)), grid_(BoxesOf(entries_)) {}

  Eigen::Index size() const { return grid_.size(); }
  const Entry& operator[](Eigen::Index i) const { return entries_[i]; }

  bool OverlapsAny(const RoundedBox& box) const {
    return grid_.OverlapsAny(box);
  }

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
    const std::vector<BoxedMesh>& meshes, size_t num_muscles) {
  std::vector<std::vector<char>> are_proper(num_muscles);
  for (size_t mesh = 0; mesh < num_muscles; ++mesh) {
    const SurfaceView& view = meshes[mesh].view();
    if (view.rings) are_proper[mesh] = ProperStars(*view.rings, *view.points);
  }
  return are_proper;
}

// Adds the pair of two triangles whose boxes overlap, if they cross.
void AddIfCrossing(const Entry& other,
                   const Entry& entry,
                   std::vector<CrossingPair>* pairs) {
  const bool cross =
      entry.mesh == other.mesh
          ? TrianglesIntersectBeyondCommon(other.corners, entry.corners)
          : TrianglesIntersect(other.corners, entry.corners);
  if (!cross) return;
  pairs->push_back({other.mesh, entry.mesh, other.triangle, entry.triangle});
}

// Calls find(i, pairs) for all i below `count`, on several threads, and adds
// the pairs.
template <typename Find>
void AddFound(int count, const Find& find, std::vector<CrossingPair>* pairs) {
#pragma omp parallel
  {
    std::vector<CrossingPair> found;
#pragma omp for schedule(dynamic, 256) nowait
    for (int i = 0; i < count; ++i) find(i, &found);
#pragma omp critical
    pairs->insert(pairs->end(), found.begin(), found.end());
  }
}

// Adds the pairs of triangles of muscles. Those around a vertex with a proper
// star are known not to cross.
void AddPairsOfMuscles(const std::vector<BoxedMesh>& meshes,
                       size_t num_muscles,
                       const MuscleTriangles& all,
                       std::vector<CrossingPair>* pairs) {
  const std::vector<std::vector<char>> are_proper =
      ProperStarsOf(meshes, num_muscles);
  const auto find = [&](int i, std::vector<CrossingPair>* found) {
    const Entry& entry = all[i];
    const std::vector<char>& is_proper = are_proper[entry.mesh];
    all.ForEachOverlap(entry, i, [&](const Entry& other) {
      if (entry.mesh == other.mesh && !is_proper.empty() &&
          ShareProperStar(*meshes[entry.mesh].view().triangles,
                          is_proper,
                          entry.triangle,
                          other.triangle)) {
        return;
      }
      AddIfCrossing(other, entry, found);
    });
  };
  AddFound(static_cast<int>(all.size()), find, pairs);
}

// Adds the pairs of triangles of muscles and a bone, cluster by cluster.
void AddPairsOfBone(const BoxedMesh& boxed,
                    int mesh,
                    const MuscleTriangles& all,
                    std::vector<CrossingPair>* pairs) {
  const auto find = [&](int c, std::vector<CrossingPair>* found) {
    if (!all.OverlapsAny(boxed.cluster_boxes()[c])) return;
    for (const int* g = boxed.clusters().begin(c); g < boxed.clusters().end(c);
         ++g) {
      const Entry entry = EntryOf(boxed, mesh, *g);
      all.ForEachOverlap(entry, all.size(), [&](const Entry& other) {
        AddIfCrossing(other, entry, found);
      });
    }
  };
  AddFound(boxed.clusters().size(), find, pairs);
}

}  // namespace

std::vector<CrossingPair> CrossingTriangles(
    const std::vector<BoxedMesh>& meshes, size_t num_muscles) {
  CHECK_LE(num_muscles, meshes.size());
  const MuscleTriangles all(meshes, num_muscles);
  std::vector<CrossingPair> pairs;
  AddPairsOfMuscles(meshes, num_muscles, all, &pairs);
  for (size_t b = num_muscles; b < meshes.size(); ++b) {
    AddPairsOfBone(meshes[b], static_cast<int>(b), all, &pairs);
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
