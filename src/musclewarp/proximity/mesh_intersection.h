// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/proximity/winding_number.h"

namespace musclewarp {

// A mesh together with the search structures that queries about intersections
// need, so that they are built once for many queries. The triangles are fixed;
// Refit() follows moving points in linear time. Any triangle soup is allowed,
// and its triangles keep their numbers.
class SearchableMesh {
 public:
  // Takes the points (#V x 3) and triangles (#F x 3) of a mesh and builds a
  // tree over the triangles.
  explicit SearchableMesh(TriangleSoup soup);

  // A copy has trees of its own.
  SearchableMesh(const SearchableMesh& other)
      : soup_(other.soup_),
        bvh_(other.bvh_),
        winding_(&bvh_, other.winding_),
        is_used_(other.is_used_),
        components_(other.components_) {}
  SearchableMesh& operator=(const SearchableMesh&) = delete;

  // Moves the points to new positions, #V x 3. Precondition (CHECKed): there
  // are as many as before.
  void Refit(const Points& points);

  const TriangleSoup& soup() const { return soup_; }
  const Points& points() const { return soup_.points; }
  const Triangles& triangles() const { return soup_.triangles; }
  const TriangleBvh& bvh() const { return bvh_; }
  const WindingNumber& winding() const { return winding_; }

  // For every point (#V), whether a triangle uses it.
  const std::vector<char>& is_used() const { return is_used_; }

  // For every point (#V), the lowest index of a point that is connected to it
  // over triangles. Two points are in the same component if these are equal.
  const std::vector<int>& components() const { return components_; }

 private:
  TriangleSoup soup_;
  TriangleBvh bvh_;
  WindingNumber winding_;
  std::vector<char> is_used_;
  std::vector<int> components_;
};

// Where two meshes a and b intersect, and how deeply. A point is inside a mesh
// if its generalized winding number is above 1/2, which is defined for open and
// non-manifold meshes as well. Points on the surface are not inside. All lists
// are in ascending order, and no result depends on the number of threads.
struct MeshIntersection {
  // The pairs of a triangle of a and a triangle of b that share a point, found
  // by an exact test.
  std::vector<std::pair<int, int>> triangle_pairs;

  // The vertices of one mesh that are inside the other one. Points that no
  // triangle uses do not count.
  std::vector<int> a_inside_b;
  std::vector<int> b_inside_a;

  // The distance from the deepest of these vertices to the surface of the other
  // mesh, mm, and the larger of the two. 0 if there are no such vertices.
  double a_depth_mm = 0;
  double b_depth_mm = 0;
  double max_depth_mm = 0;

  // Returns true if the meshes do not touch.
  bool IsEmpty() const {
    return triangle_pairs.empty() && a_inside_b.empty() && b_inside_a.empty();
  }
};

// Returns where two meshes intersect. Pass SearchableMesh if one of them takes
// part in several intersections; the other form builds both and discards them.
MeshIntersection IntersectMeshes(const SearchableMesh& a,
                                 const SearchableMesh& b);
MeshIntersection IntersectMeshes(const TriangleSoup& a, const TriangleSoup& b);

// Returns the pairs of a triangle of a and a triangle of b that share a point,
// in ascending order. These are the triangle_pairs of IntersectMeshes, without
// the cost of testing vertices.
std::vector<std::pair<int, int>> IntersectingTriangles(const TriangleBvh& a,
                                                       const TriangleBvh& b);

// Returns the pairs (f, g) of triangles at which a mesh intersects itself, with
// f < g and in ascending order. The two share a point beyond the corner or edge
// they have in common, by an exact test. Corners are common if their
// coordinates are equal, whatever their indices; equal triangles intersect.
std::vector<std::pair<int, int>> SelfIntersections(const TriangleBvh& bvh);
std::vector<std::pair<int, int>> SelfIntersections(const TriangleSoup& soup);

}  // namespace musclewarp
