// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A set of vertices of one mesh that lie inside another mesh and are connected
// by edges (paper section 3.2, fig. 3.2).
struct Region {
  std::vector<int> vertices;  // indices in rising order
  Eigen::RowVector3d centre;  // the mean of the vertices, mm
};

// Splits the vertices `inside` (indices in rising order) of a mesh with
// `points` (#V x 3, mm) into connected regions, sorted by their lowest vertex.
std::vector<Region> ConnectedRegions(const std::vector<int>& inside,
                                     const Points& points,
                                     const Triangles& triangles);

// Pairs regions of two meshes greedily: of all pairs whose centres are at most
// `max_distance` (mm) apart, the closest is taken first, and a region is paired
// at most once. Pairs at equal distances are taken in the order of their
// indices. Returns pairs (index into a, index into b), the closest first.
std::vector<std::pair<int, int>> PairRegions(const std::vector<Region>& a,
                                             const std::vector<Region>& b,
                                             double max_distance);

}  // namespace musclewarp
