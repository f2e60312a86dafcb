// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/initial_separation/distance_samples.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

// The signed distance to a closed surface, mm: negative inside. For most
// positions, cached samples show without a search that the position is far from
// the surface, or on which side it is.
//
//   const SolidDistance distance(femur);
//   if (distance.At(p, /*limit=*/3) < 0) ...  // p is inside
class SolidDistance {
 public:
  // Samples the distance to a mesh on demand. Keeps a reference: the mesh must
  // neither move nor be destroyed.
  explicit SolidDistance(const SearchableMesh& mesh);

  // Returns the signed distance of a position, cut off at `limit` (mm) outside;
  // inside it is always exact.
  double At(const Eigen::RowVector3d& p, double limit) const;

  // Returns an upper bound of the signed distance without a search; infinity
  // where the samples give none.
  double UpperBound(const Eigen::RowVector3d& p) const;

  const SearchableMesh& mesh() const { return mesh_; }

 private:
  const SearchableMesh& mesh_;
  DistanceSamples samples_;
};

}  // namespace musclewarp
