// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/view_mesh.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/mesh.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {
namespace {

bool IsManifold(const TriangleSoup& soup) {
  const MeshDefects defects = CountDefects(soup);
  return defects.is_closed_manifold && defects.misoriented_edges == 0 &&
         defects.degenerate_triangles == 0;
}

}  // namespace

ViewMesh ViewMeshOf(const TriangleSoup& soup, int max_triangles) {
  if (soup.triangles.rows() <= max_triangles || !IsManifold(soup)) {
    return {soup, 0};
  }
  Mesh mesh = MeshFromSoup(soup);
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, max_triangles);
  mesh.garbage_collection();

  ViewMesh view{SoupFromMesh(mesh), 0};
  const TriangleBvh surface(view.soup.points, view.soup.triangles);
  for (Eigen::Index v = 0; v < soup.points.rows(); ++v) {
    view.max_error = std::max(
        view.max_error, surface.ClosestPoint(soup.points.row(v)).distance);
  }
  return view;
}

}  // namespace musclewarp
