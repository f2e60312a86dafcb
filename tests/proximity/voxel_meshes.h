// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A solid of unit cubes on the integer lattice: handles, cavities, several
// pieces, cubes that touch in an edge or a corner. Everything is degenerate,
// and what is inside is known exactly.
class VoxelSolid {
 public:
  // `size`^3 cubes, each there with the probability.
  VoxelSolid(int size, double probability, std::mt19937* random)
      : size_(size), is_full_(size * size * size) {
    std::bernoulli_distribution full(probability);
    for (auto cube : is_full_) cube = full(*random);
  }

  bool IsFull(int x, int y, int z) const {
    return std::min({x, y, z}) >= 0 && std::max({x, y, z}) < size_ &&
           is_full_[(z * size_ + y) * size_ + x];
  }

  // All cubes that a point touches are full.
  bool Contains(const Eigen::RowVector3d& p) const {
    for (int corner = 0; corner < 8; ++corner) {
      std::array<int, 3> cube;
      for (int k = 0; k < 3; ++k) {
        cube[k] = static_cast<int>((corner >> k) & 1 ? std::ceil(p[k]) - 1
                                                     : std::floor(p[k]));
      }
      if (!IsFull(cube[0], cube[1], cube[2])) return false;
    }
    return true;
  }

  // Its surface, outward; two triangles for every face between a full cube and
  // an empty one.
  TriangleSoup Surface() const {
    std::map<std::array<int, 3>, int> points;
    std::vector<std::array<int, 3>> triangles;
    const auto index = [&](std::array<int, 3> p) {
      return points.emplace(p, static_cast<int>(points.size())).first->second;
    };
    for (int cell = 0; cell < size_ * size_ * size_; ++cell) {
      const std::array<int, 3> cube = {
          cell % size_, cell / size_ % size_, cell / size_ / size_};
      if (!IsFull(cube[0], cube[1], cube[2])) continue;
      for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          std::array<int, 3> next = cube;
          next[axis] += 2 * side - 1;
          if (IsFull(next[0], next[1], next[2])) continue;
          std::array<int, 4> corners;
          for (int c = 0; c < 4; ++c) {
            std::array<int, 3> p = cube;
            p[axis] += side;
            p[(axis + 1) % 3] += c == 1 || c == 2;
            p[(axis + 2) % 3] += c >= 2;
            corners[c] = index(p);
          }
          if (side == 0) std::swap(corners[1], corners[3]);
          triangles.push_back({corners[0], corners[1], corners[2]});
          triangles.push_back({corners[0], corners[2], corners[3]});
        }
      }
    }
    TriangleSoup soup;
    soup.points.resize(points.size(), 3);
    for (const auto& [p, i] : points) {
      soup.points.row(i) << p[0], p[1], p[2];
    }
    soup.triangles.resize(triangles.size(), 3);
    for (size_t f = 0; f < triangles.size(); ++f) {
      soup.triangles.row(f) << triangles[f][0], triangles[f][1],
          triangles[f][2];
    }
    return soup;
  }

 private:
  int size_;
  std::vector<bool> is_full_;
};

}  // namespace musclewarp
