// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/certified_contact/vertex_blocks.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/self_crossing_search.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// Bounds on the edge weights of a MuscleSurface, so that degenerate triangles
// do not dominate them.
struct MuscleSurfaceOptions {
  // Bounds of the weight of an edge. The weights of needle triangles are
  // unbounded, and a single one would lock all vertices around it.
  double min_edge_weight = 1e-2;
  double max_edge_weight = 1e2;

  bool IsValid(std::string* error) const;
};

// The constant data of a muscle in certified contact, computed once for all
// poses. The weighted graph of its edges smooths the offsets of vertices by
// contact (relaxation.h).
struct MuscleSurface {
  Points rest;          // #V x 3, mm
  Triangles triangles;  // closed, oriented outward
  double volume = 0;    // to be preserved, mm^3

  std::shared_ptr<const TriangleBvh> tree;  // of the rest pose
  std::shared_ptr<const SelfCrossingSearch> self_crossings;

  // By bone: for each triangle (#F), true if it may cross the bone
  // (exempt_area.h). Empty if none may.
  std::vector<std::vector<char>> exempt;

  // The neighbours of vertex v are neighbours[first[v]] to
  // neighbours[first[v + 1] - 1].
  std::vector<int> first;
  std::vector<int> neighbours;

  // The weights of the edges to these neighbours: two thirds of the area of the
  // triangles at an edge over its squared length. For equilateral triangles
  // that is the cotangent weight; it is positive for all others.
  std::vector<double> weights;

  // The lengths of these edges at rest, mm.
  std::vector<double> lengths;

  VertexBlocks blocks;  // for sweeps on several threads

  // #V: a third of the area of the triangles around a vertex at rest, mm^2.
  Eigen::VectorXd areas;

  int num_vertices() const { return static_cast<int>(areas.size()); }

  // True if a triangle may cross a bone.
  bool IsExempt(int bone, Eigen::Index triangle) const {
    return !exempt.empty() && !exempt[bone].empty() && exempt[bone][triangle];
  }
};

// Computes the edge weights, areas and search tree of a muscle. `rest`: #V x 3,
// mm; `volume`: mm^3. Precondition (CHECKed): the options are valid.
MuscleSurface MakeMuscleSurface(const Points& rest,
                                const Triangles& triangles,
                                double volume,
                                const MuscleSurfaceOptions& options = {});

}  // namespace musclewarp
