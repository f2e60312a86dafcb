// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "musclewarp/certificate/box_grid.h"
#include "musclewarp/certificate/boxed_mesh.h"

namespace musclewarp {

// The smallest distance of the surfaces of two meshes a and b, mm: it is proved
// to be in [at_least, at_most], and both are 0 if triangles share a point.
struct MeshDistance {
  double at_least = 0;
  double at_most = 0;

  // The two triangles that at_most was found for, and the mid-point of their
  // closest points, mm.
  int triangle_of_a = -1;
  int triangle_of_b = -1;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

// Searches for the smallest distance of a mesh to other ones. The certificate
// proves with it how wide the gap between two meshes is. As for crossing
// triangles, the code shares only exact tests with contact: a grid of boxes,
// where contact searches trees, and BoundDistance, where contact computes
// closest points in floating point.
//
//   const BoxedMesh psoas({&points, &triangles}), femur(...);
//   const DistanceSearch search(psoas, /*limit=*/2);
//   if (const auto distance = search.To(femur)) {
//     std::cout << "at least " << distance->at_least << " mm apart";
//   }
//
// Why at_least is proved: a pair of triangles is left out only if its boxes,
// which are rounded outward, or the lower bound of BoundDistance are farther
// apart than an upper bound of the distance that has been found already, or
// than the limit. For every other pair at_least is at most the lower bound of
// BoundDistance.
class DistanceSearch {
 public:
  // Sorts the triangles of `mesh` into a grid. Keeps a reference to `mesh`. A
  // distance of more than `limit` (mm, above 0) is not looked for.
  DistanceSearch(const BoxedMesh& mesh, double limit);

  // Returns the distance to another mesh, or nothing if the two are proved to
  // be farther apart than the limit. Triangles of the mesh of this search for
  // which `exempt` (#F, may be null) is true do not count. The result does not
  // depend on the number of threads; nor do the distances depend on which of
  // the two meshes is searched. Of triangles that are equally near, those with
  // the lowest numbers are named.
  std::optional<MeshDistance> To(
      const BoxedMesh& other, const std::vector<char>* exempt = nullptr) const;

 private:
  const BoxedMesh& mesh_;
  double limit_;
  std::vector<RoundedBox> boxes_;  // of the triangles of the mesh
  BoxGrid grid_;
};

}  // namespace musclewarp
