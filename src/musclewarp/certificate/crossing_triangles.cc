// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/crossing_triangles.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "musclewarp/base/wide_registers.h"
#include "musclewarp/certificate/box_grid.h"
#include "musclewarp/cgal/triangle_intersection.h"

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

// Triangles of muscles by their numbers, with their boxes by coordinate, so
// that another box is compared with several of them at once.
class NearTriangles {
 public:
  int size() const { return static_cast<int>(numbers_.size()); }

  void Clear() {
    numbers_.clear();
    for (std::vector<float>& values : extents_) values.clear();
  }

  void Add(int number, const RoundedBox& box) {
    numbers_.push_back(number);
    for (int k = 0; k < 3; ++k) {
      extents_[k].push_back(box.lower[k]);
      extents_[3 + k].push_back(box.upper[k]);
    }
  }

  // Calls visit(number) for those whose boxes overlap `box`.
  template <typename Visit>
  void ForEachOverlap(const RoundedBox& box, const Visit& visit) {
    overlaps_.resize(size());
    Compare(box, extents_, size(), overlaps_.data());
    for (int i = 0; i < size(); ++i) {
      if (overlaps_[i]) visit(numbers_[i]);
    }
  }

 private:
  using Extents = std::array<std::vector<float>, 6>;  // lower, then upper

  static MUSCLEWARP_WIDE void Compare(const RoundedBox& box,
                                      const Extents& extents,
                                      int count,
                                      int* overlaps) {
    const float *x0 = extents[0].data(), *y0 = extents[1].data(),
                *z0 = extents[2].data(), *x1 = extents[3].data(),
                *y1 = extents[4].data(), *z1 = extents[5].data();
    const std::array<float, 3> lower = box.lower, upper = box.upper;
#pragma omp simd
    for (int i = 0; i < count; ++i) {
      overlaps[i] = (lower[0] <= x1[i]) & (x0[i] <= upper[0]) &
                    (lower[1] <= y1[i]) & (y0[i] <= upper[1]) &
                    (lower[2] <= z1[i]) & (z0[i] <= upper[2]);
    }
  }

  std::vector<int> numbers_;
  Extents extents_;
  std::vector<int> overlaps_;
};

// The triangles of the muscles, by the cells that their boxes touch.
class MuscleTriangles {
 public:
  MuscleTriangles(const std::vector<BoxedMesh>& meshes, size_t num_muscles)
      : entries_(EntriesOf(meshes, num_muscles)),
        boxes_(BoxesOf(entries_)),
        grid_(boxes_) {}

  // Triangles are numbered muscle by muscle.
  int size() const { return static_cast<int>(entries_.size()); }
  const Entry& operator[](int number) const { return entries_[number]; }

  // Sets `near` to those of the first `count` triangles whose boxes overlap
  // `box`.
  void FindNear(const RoundedBox& box, int count, NearTriangles* near) const {
    near->Clear();
    grid_.ForEachOverlap(box, count, [&](int i) { near->Add(i, boxes_[i]); });
  }

 private:
  static std::vector<RoundedBox> BoxesOf(const std::vector<Entry>& entries) {
    std::vector<RoundedBox> boxes;
    boxes.reserve(entries.size());
    for (const Entry& entry : entries) boxes.push_back(entry.box);
    return boxes;
  }

  std::vector<Entry> entries_;
  std::vector<RoundedBox> boxes_;
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

// Calls test(triangle, near, pairs) for every triangle of a mesh, on several
// threads, and adds the pairs; `near` has those of the first count(last)
// triangles of muscles that are near the cluster of the triangle, whose last
// triangle is `last`.
template <typename Count, typename Test>
void AddFound(const BoxedMesh& boxed,
              const MuscleTriangles& all,
              const Count& count,
              const Test& test,
              std::vector<CrossingPair>* pairs) {
  const TriangleClusters& clusters = boxed.clusters();
#pragma omp parallel
  {
    std::vector<CrossingPair> found;
    NearTriangles near;
#pragma omp for schedule(dynamic, 64) nowait
    for (int c = 0; c < clusters.size(); ++c) {
      const int last = clusters.end(c)[-1];
      all.FindNear(boxed.cluster_boxes()[c], count(last), &near);
      if (near.size() == 0) continue;
      for (const int* f = clusters.begin(c); f < clusters.end(c); ++f) {
        test(*f, &near, &found);
      }
    }
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
  int first = 0;  // number of the first triangle of the muscle
  for (size_t mesh = 0; mesh < num_muscles; ++mesh) {
    const Triangles& triangles = *meshes[mesh].view().triangles;
    const std::vector<char>& is_proper = are_proper[mesh];
    // Each pair once: with triangles that come before.
    const auto count = [&](int last) { return first + last; };
    const auto test = [&](int f, NearTriangles* near, auto* found) {
      const Entry& entry = all[first + f];
      near->ForEachOverlap(entry.box, [&](int other) {
        if (other >= first + f) return;
        if (other >= first && !is_proper.empty() &&
            ShareProperStar(triangles, is_proper, f, other - first)) {
          return;
        }
        AddIfCrossing(all[other], entry, found);
      });
    };
    AddFound(meshes[mesh], all, count, test, pairs);
    first += static_cast<int>(triangles.rows());
  }
}

// Adds the pairs of triangles of muscles and a bone.
void AddPairsOfBone(const BoxedMesh& boxed,
                    int mesh,
                    const MuscleTriangles& all,
                    std::vector<CrossingPair>* pairs) {
  const auto count = [&](int) { return all.size(); };
  const auto test = [&](int f, NearTriangles* near, auto* found) {
    const Entry entry = EntryOf(boxed, mesh, f);
    near->ForEachOverlap(
        entry.box, [&](int other) { AddIfCrossing(all[other], entry, found); });
  };
  AddFound(boxed, all, count, test, pairs);
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
