// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/bone_overlaps.h"

#include <glog/logging.h>

namespace musclewarp {
namespace {

// Moves the overlap to the deepest of the vertices, if it is deeper.
void Deepen(const SearchableMesh& mesh,
            const std::vector<int>& inside,
            const SearchableMesh& other,
            BoneOverlap* overlap) {
  for (const int v : inside) {
    const Eigen::RowVector3d point = mesh.points().row(v);
    if (other.bvh().IsWithin(point, overlap->depth_mm)) continue;
    overlap->depth_mm = other.bvh().ClosestPoint(point).distance;
    overlap->place = point;
  }
}

}  // namespace

std::vector<BoneOverlap> BoneOverlaps(const std::vector<NamedMesh>& bones,
                                      const std::vector<std::string>& bodies) {
  CHECK_EQ(bones.size(), bodies.size());
  std::vector<BoneOverlap> overlaps;
  for (size_t i = 0; i < bones.size(); ++i) {
    for (size_t j = i + 1; j < bones.size(); ++j) {
      if (bodies[i] == bodies[j]) continue;
      const SearchableMesh &a = *bones[i].mesh, &b = *bones[j].mesh;
      const MeshIntersection found = IntersectMeshes(a, b);
      BoneOverlap overlap = {bones[i].name, bones[j].name};
      Deepen(a, found.a_inside_b, b, &overlap);
      Deepen(b, found.b_inside_a, a, &overlap);
      if (overlap.depth_mm > 0) overlaps.push_back(std::move(overlap));
    }
  }
  return overlaps;
}

}  // namespace musclewarp
