// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/mesh_distance.h"

#include <glog/logging.h>

#include <algorithm>
#include <atomic>
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

std::vector<RoundedBox> BoxesOf(const BoxedMesh& mesh) {
  std::vector<RoundedBox> boxes(mesh.num_triangles());
#pragma omp parallel for schedule(static)
  for (Eigen::Index f = 0; f < mesh.num_triangles(); ++f) {
    boxes[f] = RoundedBoxOf(mesh.corners(f));
  }
  return boxes;
}

}  // namespace

DistanceSearch::DistanceSearch(const BoxedMesh& mesh, double limit)
    : mesh_(mesh), limit_(limit), boxes_(BoxesOf(mesh)), grid_(boxes_) {
  CHECK_GT(limit, 0);
}

std::optional<MeshDistance> DistanceSearch::To(
    const BoxedMesh& other, const std::vector<char>* exempt) const {
  const RoundedBox near = mesh_.box().GrownBy(limit_);
  if (grid_.size() == 0 || !near.Overlaps(other.box())) return std::nullopt;
  Reach reach(limit_);
  Nearest nearest;
  const auto test = [&](int f, int g, const RoundedBox& box, Nearest* found) {
    if (exempt && (*exempt)[f]) return;
    const double within = reach.Get();
    if (AreBeyond(boxes_[f], box, within)) return;
    const DistanceBounds bounds =
        BoundDistance(mesh_.corners(f), other.corners(g), within);
    if (bounds.at_least > within) return;
    found->Add(bounds, f, g);
    reach.LowerTo(bounds.at_most);
  };
  const TriangleClusters& clusters = other.clusters();
  // Few clusters, spread over the mesh, shorten the reach for the others.
  constexpr int kSampleStride = 64;
  for (const int stride : {kSampleStride, 1}) {
#pragma omp parallel
    {
      Nearest found;
#pragma omp for schedule(dynamic, 8) nowait
      for (int c = 0; c < clusters.size(); c += stride) {
        const RoundedBox around = other.cluster_boxes()[c].GrownBy(reach.Get());
        if (!near.Overlaps(around) || !grid_.OverlapsAny(around)) continue;
        for (const int* g = clusters.begin(c); g < clusters.end(c); ++g) {
          const RoundedBox box = RoundedBoxOf(other.corners(*g));
          grid_.ForEachOverlap(box.GrownBy(reach.Get()),
                               grid_.size(),
                               [&](int f) { test(f, *g, box, &found); });
        }
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
