// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/decimation.h"

#include <glog/logging.h>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

Decimation Decimated(const TriangleSoup& soup,
                     const DecimationOptions& options) {
  CHECK(options.is_kept.empty() ||
        static_cast<Eigen::Index>(options.is_kept.size()) ==
            soup.points.rows());
  std::vector<int> all(soup.points.rows());
  std::iota(all.begin(), all.end(), 0);
  if (soup.triangles.rows() <= options.max_triangles || !IsManifold(soup)) {
    return {soup, std::move(all), 0};
  }
  Mesh mesh = MeshFromSoup(soup);
  OpenMesh::VPropHandleT<int> number;
  mesh.add_property(number);
  for (const int v : all) {
    mesh.property(number, mesh.vertex_handle(static_cast<unsigned>(v))) = v;
  }
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);  // adds the status
  for (size_t v = 0; v < options.is_kept.size(); ++v) {
    if (!options.is_kept[v]) continue;
    mesh.status(mesh.vertex_handle(static_cast<unsigned>(v))).set_locked(true);
  }
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  OpenMesh::Decimater::ModHausdorffT<Mesh>::Handle distance;
  if (std::isfinite(options.tolerance)) {
    decimater.add(distance);
    decimater.module(distance).set_tolerance(options.tolerance);
  }
  decimater.initialize();
  decimater.decimate_to_faces(0, options.max_triangles);
  mesh.garbage_collection();

  Decimation result{SoupFromMesh(mesh), {}, 0};
  for (const auto v : mesh.vertices()) {
    result.vertices.push_back(mesh.property(number, v));
  }
  const TriangleBvh surface(result.soup.points, result.soup.triangles);
  for (Eigen::Index v = 0; v < soup.points.rows(); ++v) {
    result.max_error = std::max(
        result.max_error, surface.ClosestPoint(soup.points.row(v)).distance);
  }
  return result;
}

}  // namespace musclewarp
