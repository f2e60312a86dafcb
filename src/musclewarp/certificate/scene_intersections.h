// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

// Two meshes of a scene that touch. Triangle pairs by an exact test.
struct PairIntersection {
  std::string a;
  std::string b;
  int triangle_pairs = 0;
  int vertices_inside = 0;  // of a in b and of b in a
  double max_depth_mm = 0;
  int exempt_pairs = 0;  // of triangles, beside triangle_pairs
  // The mean of the corners of triangles_of_a, mm: where to look.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  // Those that cross, ascending, each once; not the exempt ones.
  std::vector<int> triangles_of_a;
  std::vector<int> triangles_of_b;
};

// The sum over all muscle x muscle and muscle x bone pairs.
struct SceneIntersections {
  int triangle_pairs = 0;
  int vertices_inside = 0;
  double max_depth_mm = 0;
  int self_pairs = 0;    // of the muscles, each with itself
  int exempt_pairs = 0;  // beside triangle_pairs
  std::vector<int> self_pairs_of_muscles;
  std::vector<PairIntersection> pairs;  // those that touch, in scene order
  // By muscle: its vertices inside any other mesh, rising.
  std::vector<std::vector<int>> inside_of_muscles;

  // No triangles cross and no mesh contains another's vertices.
  bool IsClean() const { return triangle_pairs == 0 && vertices_inside == 0; }
  // Keeps the counts.
  void DropLists();
};

struct NamedMesh {
  std::string name;
  const SearchableMesh* mesh = nullptr;
};

// By code of its own, of which contact uses the exact tests alone
// (CrossingTriangles, IsInsideClosed); only where meshes do touch it asks
// IntersectMeshes for vertices and depths. Bones are not tested against each
// other, nor with themselves. Where nothing but what is exempt crosses, no
// vertices of the bone count as inside, and none of the muscle's exempt ones.
SceneIntersections IntersectScene(const std::vector<NamedMesh>& muscles,
                                  const std::vector<NamedMesh>& bones,
                                  const std::vector<ExemptArea>& exempt = {});

// By muscle: the depth of the deepest vertex of it in another mesh, or of
// another mesh in it, mm.
std::vector<double> PenetrationDepths(const std::vector<NamedMesh>& muscles,
                                      const std::vector<NamedMesh>& bones);

// For each vertex of muscle `muscle`: the distance to the nearest other mesh,
// mm, negative inside one (`inside`, from IntersectScene); `limit` where
// nothing is nearer than that.
Eigen::VectorXd VertexGaps(size_t muscle,
                           const std::vector<NamedMesh>& muscles,
                           const std::vector<NamedMesh>& bones,
                           const std::vector<int>& inside,
                           double limit);

}  // namespace musclewarp
