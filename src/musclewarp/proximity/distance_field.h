// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

// A smooth signed distance to closed surfaces, negative inside: a quadratic
// B-spline over samples of the distance on a lattice, so that its gradient is
// continuous. Samples are taken when they are first asked for, from any thread,
// and do not depend on which. The lattice is that of the multiples of the
// spacing, whatever the box of the surfaces.
class DistanceField {
 public:
  // What a place in the field has, lengths in mm.
  struct Value {
    double distance = 0;
    Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
    Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  // second derivatives
  };

  // Takes the surfaces, of which there is at least one (CHECKed), and the
  // spacing of the samples (mm). Outside, distances beyond `reach` (mm) are not
  // known.
  DistanceField(const std::vector<TriangleSoup>& surfaces,
                double spacing,
                double reach);

  // Returns true if the distance at a place is below `limit` (mm, at most the
  // reach), and then sets `value`.
  bool IsBelow(double limit,
               const Eigen::RowVector3d& place,
               Value* value) const;

  // The box of the surfaces.
  const Box3& box() const { return box_; }

 private:
  using Place = Eigen::Array<int, 1, 3>;

  double Sample(const Place& at) const;

  std::vector<std::unique_ptr<SearchableMesh>> surfaces_;
  double spacing_, reach_;
  Box3 box_;
  Place first_, size_;
  mutable std::unique_ptr<std::atomic<float>[]> samples_;  // NaN: not yet taken
};

}  // namespace musclewarp
