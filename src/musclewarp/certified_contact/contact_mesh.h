// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What contact needs of a muscle and what stays the same. The graph of its
// edges carries the offsets that contact makes (ContactRelaxation).
struct ContactMesh {
  Triangles triangles;  // closed, outward
  double volume = 0;    // to be kept, mm^3
  int self_pairs = 0;   // of triangles that cross each other at rest
  std::shared_ptr<const TriangleBvh> tree;  // at rest
  // By bone: the triangles (#F) that may be in it; empty where none may.
  std::vector<std::vector<char>> exempt;

  // The neighbours of vertex v are neighbours[first[v]] to
  // neighbours[first[v + 1] - 1].
  std::vector<int> first;
  std::vector<int> neighbours;
  // Of the edges to them: the area beside an edge over its length squared,
  // which is the cotangent weight where triangles are equilateral, and positive
  // where they are not.
  std::vector<double> weights;
  Eigen::VectorXd areas;  // #V: a third of the rest triangles around, mm^2

  // `rest`: #V x 3, mm.
  static ContactMesh Of(const Points& rest,
                        const Triangles& triangles,
                        double volume);

  int num_vertices() const { return static_cast<int>(areas.size()); }
  bool IsExempt(int bone, Eigen::Index triangle) const {
    return !exempt.empty() && !exempt[bone].empty() && exempt[bone][triangle];
  }
};

}  // namespace musclewarp
