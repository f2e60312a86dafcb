// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Vertices of one mesh that lie inside another and hang together by edges;
// paper section 3.2, fig. 3.2.
struct Region {
  std::vector<int> vertices;  // rising
  Eigen::RowVector3d centre;  // their mean, mm
};

// The regions of the vertices `inside` (rising), by lowest vertex.
std::vector<Region> ConnectedRegions(const std::vector<int>& inside,
                                     const Points& points,
                                     const Triangles& triangles);

// Pairs (index into a, index into b) of regions with the closest centres among
// those not yet paired, closest first, at most max_distance (mm) apart. Equal
// distances go by index.
std::vector<std::pair<int, int>> PairRegions(const std::vector<Region>& a,
                                             const std::vector<Region>& b,
                                             double max_distance);

}  // namespace musclewarp
