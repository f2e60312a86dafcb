// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/muscle_surface.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "musclewarp/base/option_check.h"

namespace musclewarp {
namespace {

// The largest number of vertices of a block: some microseconds of work, which
// is much more than it takes to give a block to a thread.
constexpr int kBlock = 64;

}  // namespace

bool MuscleSurfaceOptions::IsValid(std::string* error) const {
  return OptionCheck("MuscleSurfaceOptions", error)
      .IsAbove("min_edge_weight", min_edge_weight, 0)
      .IsAtLeast("max_edge_weight", max_edge_weight, min_edge_weight)
      .is_valid();
}

MuscleSurface MakeMuscleSurface(const Points& rest,
                                const Triangles& triangles,
                                double volume,
                                const MuscleSurfaceOptions& options) {
  using Eigen::RowVector3d;
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  MuscleSurface surface;
  surface.rest = rest;
  surface.triangles = triangles;
  surface.volume = volume;
  surface.tree = std::make_shared<TriangleBvh>(rest, triangles);
  surface.self_crossings =
      std::make_shared<SelfCrossingSearch>(rest, triangles);
  surface.areas = Eigen::VectorXd::Zero(rest.rows());
  std::vector<std::map<int, double>> around(rest.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const RowVector3d a = rest.row(triangles(f, 0));
    const RowVector3d u = rest.row(triangles(f, 1)) - a;
    const RowVector3d v = rest.row(triangles(f, 2)) - a;
    const double area = u.cross(v).norm() / 2;
    for (int k = 0; k < 3; ++k) {
      const int i = triangles(f, k);
      const int j = triangles(f, (k + 1) % 3);
      const double square = (rest.row(i) - rest.row(j)).squaredNorm();
      const double weight =
          square > 0 ? 2.0 / 3 * area / square : options.max_edge_weight;
      around[i][j] += weight;
      around[j][i] += weight;
      surface.areas[i] += area / 3;
    }
  }
  surface.first.push_back(0);
  for (size_t v = 0; v < around.size(); ++v) {
    for (const auto& [neighbour, weight] : around[v]) {
      surface.neighbours.push_back(neighbour);
      surface.lengths.push_back((rest.row(neighbour) - rest.row(v)).norm());
      surface.weights.push_back(
          std::clamp(weight, options.min_edge_weight, options.max_edge_weight));
    }
    surface.first.push_back(static_cast<int>(surface.neighbours.size()));
  }
  surface.blocks =
      MakeVertexBlocks(rest, surface.first, surface.neighbours, kBlock);
  return surface;
}

}  // namespace musclewarp
