// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/geometry/winding_number.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A mesh with what queries need. The topology is fixed, Refit() follows moving
// points in linear time. Any soup will do; its triangles keep their numbers.
class SearchableMesh {
 public:
  explicit SearchableMesh(TriangleSoup soup);
  SearchableMesh(const SearchableMesh&) = delete;
  SearchableMesh& operator=(const SearchableMesh&) = delete;

  // New positions, #V x 3.
  void Refit(const Points& points);

  const Points& points() const { return soup_.points; }
  const Triangles& triangles() const { return soup_.triangles; }
  const TriangleBvh& bvh() const { return bvh_; }
  const WindingNumber& winding() const { return winding_; }

  // #V: whether a triangle has the point; a point of the same component.
  const std::vector<char>& is_used() const { return is_used_; }
  const std::vector<int>& components() const { return components_; }

 private:
  TriangleSoup soup_;
  TriangleBvh bvh_;
  WindingNumber winding_;
  std::vector<char> is_used_;
  std::vector<int> components_;
};

// How two meshes intersect. "Inside" is a generalized winding number above 1/2,
// which has an answer for open and non-manifold meshes too; points on the
// surface are not inside. All lists ascend. Nothing depends on the number of
// threads.
struct MeshIntersection {
  // Triangles of a and of b that share a point, by an exact test.
  std::vector<std::pair<int, int>> triangle_pairs;

  // Vertices of triangles of the one inside the other.
  std::vector<int> a_inside_b;
  std::vector<int> b_inside_a;

  // Distance of the deepest of them to the other's surface, mm; 0 for none.
  double a_depth_mm = 0;
  double b_depth_mm = 0;
  double max_depth_mm = 0;

  bool IsEmpty() const {
    return triangle_pairs.empty() && a_inside_b.empty() && b_inside_a.empty();
  }
};

MeshIntersection IntersectMeshes(const SearchableMesh& a,
                                 const SearchableMesh& b);
MeshIntersection IntersectMeshes(const TriangleSoup& a, const TriangleSoup& b);

// The pairs of triangles of a and b that share a point, ascending: what
// IntersectMeshes says of triangles, without the vertices.
std::vector<std::pair<int, int>> IntersectingTriangles(const TriangleBvh& a,
                                                       const TriangleBvh& b);

// The pairs of triangles (f < g, ascending) of one mesh that share a point
// beyond the corner or edge they have in common, by an exact test. Corners are
// common if their coordinates are equal; equal triangles intersect.
std::vector<std::pair<int, int>> SelfIntersections(const TriangleBvh& bvh);
std::vector<std::pair<int, int>> SelfIntersections(const TriangleSoup& soup);

}  // namespace musclewarp
