// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/marching_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Place = DistanceSamples::Place;

// Collects the triangles in the tetrahedra, with one vertex for each lattice
// edge that the boundary crosses.
class Border {
 public:
  explicit Border(const DistanceSamples& samples) : samples_(samples) {}

  // `corners`: indices of the samples at the corners, positively oriented.
  void AddTetrahedron(const std::array<std::int64_t, 4>& corners) {
    std::array<int, 4> inside, outside;
    int num_inside = 0, num_outside = 0;
    for (int k = 0; k < 4; ++k) {
      if (samples_.value(corners[k]) < 0) {
        inside[num_inside++] = k;
      } else {
        outside[num_outside++] = k;
      }
    }
    if (num_inside == 0 || num_outside == 0) return;
    const auto vertex = [&](int i, int o) {
      return VertexOn(corners[inside[i]], corners[outside[o]]);
    };
    // The vertices go round the polygon. Their order is counterclockwise as
    // seen from outside if the inside corners followed by the outside corners
    // are an even permutation of a positively oriented tetrahedron.
    std::array<int, 4> order;
    std::copy_n(inside.begin(), num_inside, order.begin());
    std::copy_n(outside.begin(), num_outside, order.begin() + num_inside);
    const bool is_even = IsEven(order);
    if (num_inside == 1) {
      AddTriangle(vertex(0, 0), vertex(0, 1), vertex(0, 2), is_even);
    } else if (num_inside == 3) {
      AddTriangle(vertex(0, 0), vertex(1, 0), vertex(2, 0), is_even);
    } else {
      const int a = vertex(0, 0), b = vertex(0, 1);
      const int c = vertex(1, 1), d = vertex(1, 0);
      AddTriangle(a, b, c, is_even);
      AddTriangle(a, c, d, is_even);
    }
  }

  TriangleSoup Take() const {
    TriangleSoup soup;
    soup.points.resize(static_cast<Eigen::Index>(points_.size()), 3);
    for (size_t v = 0; v < points_.size(); ++v) soup.points.row(v) = points_[v];
    soup.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (size_t f = 0; f < triangles_.size(); ++f) {
      soup.triangles.row(f) = triangles_[f];
    }
    return soup;
  }

 private:
  static bool IsEven(const std::array<int, 4>& order) {
    int inversions = 0;
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) inversions += order[a] > order[b];
    }
    return inversions % 2 == 0;
  }

  void AddTriangle(int a, int b, int c, bool is_even) {
    triangles_.emplace_back(a, is_even ? b : c, is_even ? c : b);
  }

  int VertexOn(std::int64_t inside, std::int64_t outside) {
    // An edge of the lattice goes from its lower end in one of seven
    // directions: the coordinates of the upper end are larger by 0 or 1.
    const std::int64_t low = std::min(inside, outside);
    const std::int64_t high = std::max(inside, outside);
    const RowVector3d from = samples_.Position(inside);
    const RowVector3d to = samples_.Position(outside);
    const auto [place, is_new] = vertices_.try_emplace(
        low * 8 + Direction(low, high), static_cast<int>(points_.size()));
    if (is_new) {
      // The vertex keeps away from the ends of the edge, so that no triangle
      // has zero area. All shares shrink alike, so that surfaces that meet the
      // edge in different points still do so.
      constexpr double kEdgeMargin = 0.02;
      const double a = samples_.value(inside), b = samples_.value(outside);
      const double share = kEdgeMargin + (1 - 2 * kEdgeMargin) * a / (a - b);
      points_.push_back(from + share * (to - from));
    }
    return place->second;
  }

  std::int64_t Direction(std::int64_t low, std::int64_t high) const {
    const Place& size = samples_.size();
    std::int64_t step = high - low;
    std::int64_t direction = 0;
    if (step >= size[0] * size[1]) {
      direction |= 4;
      step -= size[0] * size[1];
    }
    if (step >= size[0]) {
      direction |= 2;
      step -= size[0];
    }
    return direction | step;
  }

  const DistanceSamples& samples_;
  std::unordered_map<std::int64_t, int> vertices_;
  std::vector<RowVector3d> points_;
  std::vector<Eigen::RowVector3i> triangles_;
};

// Returns true if the boundary passes between the corners of a cell.
bool IsCrossed(const DistanceSamples& samples, const Place& lowest) {
  int inside = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Place at = lowest + Place(corner & 1, corner >> 1 & 1, corner >> 2);
    inside += samples.value(samples.IndexOf(at)) < 0;
  }
  return inside % 8 != 0;
}

}  // namespace

TriangleSoup MarchingTetrahedra(const SignedDistanceFunction& distance,
                                const Box3& box,
                                double spacing) {
  DistanceSamples samples(distance, box, spacing);
  samples.SampleAll();
  Border border(samples);
  // The paths along the edges of a cell from its lowest to its highest corner,
  // one for each order of the axes, are its six tetrahedra (Kuhn 1960). Every
  // other one is negatively oriented.
  constexpr int kAxes[6][3] = {
      {0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const Place cells = samples.size() - 1;
  for (std::int64_t z = 0; z < cells[2]; ++z) {
    for (std::int64_t y = 0; y < cells[1]; ++y) {
      for (std::int64_t x = 0; x < cells[0]; ++x) {
        const Place lowest(x, y, z);
        if (!IsCrossed(samples, lowest)) continue;
        for (int t = 0; t < 6; ++t) {
          std::array<std::int64_t, 4> corners;
          Place at = lowest;
          corners[0] = samples.IndexOf(at);
          for (int k = 0; k < 3; ++k) {
            ++at[kAxes[t][k]];
            corners[k + 1] = samples.IndexOf(at);
          }
          if (t >= 3) std::swap(corners[0], corners[1]);
          border.AddTetrahedron(corners);
        }
      }
    }
  }
  return border.Take();
}

}  // namespace musclewarp
