// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/initial_separation/distance_samples.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

// The signed distance to a closed surface, mm: negative inside. Samples of it
// tell for most places, without a search, that they are far from the surface,
// or on which side of it they are.
//
//   const SolidDistance distance(femur);
//   if (distance.At(p, /*limit=*/3) < 0) ...  // p is inside
class SolidDistance {
 public:
  // Samples the distance to a mesh where that is asked for. Keeps a reference:
  // the mesh must neither move nor go away.
  explicit SolidDistance(const SearchableMesh& mesh);

  // Returns the signed distance of a place. Places farther outside than the
  // limit have the limit; inside it is always exact.
  double At(const Eigen::RowVector3d& p, double limit) const;

  // Returns an upper bound of the signed distance that needs no search;
  // infinity where the samples tell nothing.
  double UpperBound(const Eigen::RowVector3d& p) const;

  const SearchableMesh& mesh() const { return mesh_; }

 private:
  const SearchableMesh& mesh_;
  DistanceSamples samples_;
};

}  // namespace musclewarp
