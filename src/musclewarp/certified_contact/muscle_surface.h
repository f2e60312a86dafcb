// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

struct MuscleSurfaceOptions {
  // Bounds of the weight of an edge. Needles have weights of any size; without
  // bounds one of them would hold all vertices around it together.
  double min_edge_weight = 1e-2;
  double max_edge_weight = 1e2;

  bool IsValid(std::string* error) const;
};

// What certified contact needs to know of a muscle and what stays the same from
// pose to pose. The graph of its edges, with weights, carries the offsets by
// which contact moves single vertices (relaxation.h).
struct MuscleSurface {
  Points rest;          // #V x 3, mm
  Triangles triangles;  // closed, outward
  double volume = 0;    // to be kept, mm^3

  std::shared_ptr<const TriangleBvh> tree;  // of the rest pose

  // By bone: the triangles (#F) that may cross it (see exempt_area.h). Empty
  // where none may.
  std::vector<std::vector<char>> exempt;

  // The neighbours of vertex v are neighbours[first[v]] to
  // neighbours[first[v + 1] - 1].
  std::vector<int> first;
  std::vector<int> neighbours;

  // The weights of the edges to them: the area beside an edge over its length
  // squared. That is the cotangent weight where triangles are equilateral, and
  // it is positive where they are not.
  std::vector<double> weights;

  // #V: a third of the area of the triangles around a vertex at rest, mm^2.
  Eigen::VectorXd areas;

  int num_vertices() const { return static_cast<int>(areas.size()); }

  // True if a triangle may cross a bone.
  bool IsExempt(int bone, Eigen::Index triangle) const {
    return !exempt.empty() && !exempt[bone].empty() && exempt[bone][triangle];
  }
};

// Prepares a muscle for certified contact. `rest`: #V x 3, mm; `volume`: mm^3.
// Precondition (CHECKed): the options are valid.
MuscleSurface MakeMuscleSurface(const Points& rest,
                                const Triangles& triangles,
                                double volume,
                                const MuscleSurfaceOptions& options = {});

}  // namespace musclewarp
