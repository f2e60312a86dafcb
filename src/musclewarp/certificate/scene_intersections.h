// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/certificate/surface_view.h"
#include "musclewarp/certificate/triangle_clusters.h"
#include "musclewarp/figures/intersections.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/proximity/vertex_stars.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

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
