// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/certificate/surface_view.h"
#include "musclewarp/certificate/triangle_clusters.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/proximity/vertex_stars.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

// What two meshes of a scene that touch have in common. Pairs of triangles are
// found by an exact test.
struct PairIntersection {
  std::string a;
  std::string b;
  int triangle_pairs = 0;
  int vertices_inside = 0;  // of a in b and of b in a
  double max_depth_mm = 0;
  int exempt_pairs = 0;  // of triangles, beside triangle_pairs

  // Where to look, mm: the mean of the corners of triangles_of_a, or a vertex
  // inside if no triangles cross.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();

  // The triangles that cross, ascending, each once, without exempt ones.
  std::vector<int> triangles_of_a;
  std::vector<int> triangles_of_b;

  // The numbers of a and b among the muscles; that of a bone is -1.
  int muscle_a = -1;
  int muscle_b = -1;

  // True if more than exempt triangles cross, or one mesh has a vertex inside
  // the other.
  bool Counts() const { return triangle_pairs + vertices_inside > 0; }
};

// Gaps between two meshes are looked for up to this width, mm.
constexpr double kMeshGapLimit = 2;

// The smallest distance of two meshes of a scene that are near each other. It
// is proved to be in [at_least_mm, at_most_mm], whatever rounding does; the two
// differ by rounding only (see MeshDistance). Both are 0 if triangles of the
// meshes cross or one mesh contains a vertex of the other.
struct MeshGap {
  std::string a;
  std::string b;
  double at_least_mm = 0;
  double at_most_mm = 0;

  // The mid-point of the closest points, or where the meshes intersect, mm.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();

  // As in PairIntersection.
  int muscle_a = -1;
  int muscle_b = -1;
};

// What intersects in a scene: sums over all pairs of two muscles and of a
// muscle and a bone, and the pairs themselves.
struct SceneIntersections {
  int triangle_pairs = 0;
  int vertices_inside = 0;
  double max_depth_mm = 0;
  int self_pairs = 0;    // pairs of triangles within one muscle
  int exempt_pairs = 0;  // beside triangle_pairs
  std::vector<int> self_pairs_of_muscles;
  std::vector<PairIntersection> pairs;  // those that touch, in scene order

  // The pairs of two muscles or of a muscle and a bone that are at most
  // kMeshGapLimit apart, in scene order. Pairs that are not here are proved to
  // be farther apart. Exempt triangles do not count.
  std::vector<MeshGap> gaps;

  // By muscle: its vertices inside any other mesh, ascending.
  std::vector<std::vector<int>> inside_of_muscles;

  // True if no triangles of two meshes cross and no vertex is inside another
  // mesh.
  bool IsClean() const { return triangle_pairs == 0 && vertices_inside == 0; }

  // Returns the proved width of the narrowest gap, mm, or nothing if there is
  // no gap of at most kMeshGapLimit.
  std::optional<double> SmallestGap() const;

  // Deletes the lists of triangles and vertices and keeps the counts.
  void DropLists();
};

// A mesh of a scene and its name. Keeps pointers.
struct NamedMesh {
  std::string name;
  const SearchableMesh* mesh = nullptr;

  // They make the certificate faster, and may be left out.
  const VertexRings* rings = nullptr;  // of a muscle
  const TriangleClusters* clusters = nullptr;

  SurfaceView view() const {
    return {&mesh->points(), &mesh->triangles(), rings, clusters};
  }
};

// Counts everything that intersects in a scene and measures the gaps. Whether
// anything intersects, and how wide gaps are, is found by code that shares only
// the exact tests with contact (CrossingTriangles, IsInsideClosed,
// DistanceSearch); for meshes that do touch, IntersectMeshes counts the
// vertices inside and measures depths. Bones are tested neither against each
// other nor with themselves. If only exempt triangles of a muscle cross a bone,
// no vertex of the bone counts as inside, and no exempt vertex of the muscle
// does.
SceneIntersections IntersectScene(const std::vector<NamedMesh>& muscles,
                                  const std::vector<NamedMesh>& bones,
                                  const std::vector<ExemptArea>& exempt = {});

// How deep two meshes are in each other.
struct PairDepth {
  int a;         // a muscle
  int b;         // a muscle after it, or a bone
  bool is_bone;  // what b is
  double depth;  // of the deepest vertex of one in the other, mm
};

// Returns the pairs of meshes of which one has a vertex in the other, in scene
// order.
std::vector<PairDepth> PenetrationDepths(const std::vector<NamedMesh>& muscles,
                                         const std::vector<NamedMesh>& bones);

// Returns for each vertex of a muscle the distance to the nearest other mesh,
// mm, negative inside one (`inside`, from IntersectScene), and `limit` if
// nothing is nearer than that.
Eigen::VectorXd VertexGaps(size_t muscle,
                           const std::vector<NamedMesh>& muscles,
                           const std::vector<NamedMesh>& bones,
                           const std::vector<int>& inside,
                           double limit);

// Returns the smallest of them, in a fraction of the time.
double SmallestVertexGap(size_t muscle,
                         const std::vector<NamedMesh>& muscles,
                         const std::vector<NamedMesh>& bones,
                         const std::vector<int>& inside,
                         double limit);

}  // namespace musclewarp
