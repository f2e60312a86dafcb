// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/mesh_distance.h"

#include <glog/logging.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <tuple>

#include "musclewarp/base/infinity.h"
#include "musclewarp/certificate/triangle_distance_bounds.h"

namespace musclewarp {
namespace {

// How far the nearest pair of triangles may still be, mm: the limit, or the
// upper bound of the nearest pair that any thread has found.
class Reach {
 public:
  explicit Reach(double limit) : reach_(limit) {}

  double Get() const { return reach_.load(std::memory_order_relaxed); }

  void LowerTo(double distance) {
    double reach = Get();
    while (distance < reach &&
           !reach_.compare_exchange_weak(
               reach, distance, std::memory_order_relaxed)) {
    }
  }

 private:
  std::atomic<double> reach_;
};

// Returns true if two boxes are proved to be more than `reach` apart. The
// differences of floats are exact in double; the margin is larger than the
// rounding of the squares and their sum.
bool AreBeyond(const RoundedBox& a, const RoundedBox& b, double reach) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({static_cast<double>(a.lower[k]) - b.upper[k],
                                 static_cast<double>(b.lower[k]) - a.upper[k],
                                 0.0});
    sum += gap * gap;
  }
  return sum > reach * reach * (1 + 1e-14);
}

// The nearest of the pairs of triangles that a thread has looked at.
struct Nearest {
  double at_least = kInfinity;
  MeshDistance pair = {kInfinity, kInfinity};

  void Add(const DistanceBounds& bounds, int f, int g) {
    at_least = std::min(at_least, bounds.at_least);
    Add({at_least, bounds.at_most, f, g, bounds.place});
  }

  void Add(const Nearest& other) {
    at_least = std::min(at_least, other.at_least);
    Add(other.pair);
  }

 private:
  void Add(const MeshDistance& other) {
    if (std::tie(other.at_most, other.triangle_of_a, other.triangle_of_b) <
        std::tie(pair.at_most, pair.triangle_of_a, pair.triangle_of_b)) {
      pair = other;
    }
  }
};

}  // namespace

BoxedMesh::BoxedMesh(const SurfaceView& view)
    : view_(view), boxes_(view.triangles->rows()) {
#pragma omp parallel for schedule(static)
  for (Eigen::Index f = 0; f < num_triangles(); ++f) {
    boxes_[f] = RoundedBoxOf(corners(f));
  }
  constexpr float kLargest = std::numeric_limits<float>::max();
  box_.lower.fill(kLargest);
  box_.upper.fill(-kLargest);
  for (const RoundedBox& box : boxes_) {
    for (int k = 0; k < 3; ++k) {
      box_.lower[k] = std::min(box_.lower[k], box.lower[k]);
      box_.upper[k] = std::max(box_.upper[k], box.upper[k]);
    }
  }
}

DistanceSearch::DistanceSearch(const BoxedMesh& mesh, double limit)
    : mesh_(mesh), limit_(limit), grid_(mesh.boxes()) {
  CHECK_GT(limit, 0);
}

std::optional<MeshDistance> DistanceSearch::To(
    const BoxedMesh& other, const std::vector<char>* exempt) const {
  const RoundedBox near = mesh_.box().GrownBy(limit_);
  if (grid_.size() == 0 || !near.Overlaps(other.box())) return std::nullopt;
  Reach reach(limit_);
  Nearest nearest;
  // Few triangles, spread over the mesh, shorten the reach for the others.
  constexpr Eigen::Index kSampleStride = 64;
  for (const Eigen::Index stride : {kSampleStride, Eigen::Index{1}}) {
#pragma omp parallel
    {
      Nearest found;
#pragma omp for schedule(dynamic, 32) nowait
      for (Eigen::Index g = 0; g < other.num_triangles(); g += stride) {
        const RoundedBox& box = other.boxes()[g];
        if (!near.Overlaps(box)) continue;
        grid_.ForEachOverlap(
            box.GrownBy(reach.Get()), grid_.size(), [&](int f) {
              if (exempt && (*exempt)[f]) return;
              const double within = reach.Get();
              if (AreBeyond(mesh_.boxes()[f], box, within)) return;
              const DistanceBounds bounds =
                  BoundDistance(mesh_.corners(f), other.corners(g), within);
              if (bounds.at_least > within) return;
              found.Add(bounds, f, static_cast<int>(g));
              reach.LowerTo(bounds.at_most);
            });
      }
#pragma omp critical
      nearest.Add(found);
    }
  }
  if (nearest.at_least > limit_) return std::nullopt;
  nearest.pair.at_least = nearest.at_least;
  return nearest.pair;
}

}  // namespace musclewarp
