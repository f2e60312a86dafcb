// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <memory>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

// A smooth signed distance to a closed surface, negative inside: a quadratic
// B-spline over samples of the distance on a lattice, so that its gradient is
// continuous. Samples are taken when they are first asked for, from any thread,
// and do not depend on which. The lattice is that of the multiples of the
// spacing, whatever the box of the surface.
class DistanceField {
 public:
  // What a place in the field has, lengths in mm.
  struct Value {
    double distance = 0;
    Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
    Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  // second derivatives
  };

  // Takes the surface, which has triangles (CHECKed), and the spacing of the
  // samples (mm), which is larger for a surface so large that there would be
  // more than 2^24. Outside, samples are `reach` (mm) at most, so that
  // distances are right up to the reach less three spacings.
  DistanceField(const TriangleSoup& surface, double spacing, double reach);

  // Returns true if the distance at a place is below `limit` (mm, at most the
  // reach), and then sets `value`.
  bool IsBelow(double limit,
               const Eigen::RowVector3d& place,
               Value* value) const;

  // Returns a distance that is not reached near a place: where a second place
  // is r mm away, the distance there is larger than what is returned less r.
  // It is some two spacings less than the distance, at most the reach, and 0
  // where the field does not tell.
  double LowerBound(const Eigen::RowVector3d& place) const;

  // The box of the surface.
  const Box3& box() const { return surface_.bvh().box(); }

 private:
  using Place = Eigen::Array<int, 1, 3>;

  // Finds the sample that is nearest to a place, and where the place is from
  // it, in spacings; returns false if the place is not inside of the lattice.
  bool FindNearest(const Eigen::RowVector3d& place,
                   Place* sample,
                   std::array<double, 3>* offsets) const;
  double Sample(const Place& at) const;

  SearchableMesh surface_;
  double spacing_, reach_;
  Eigen::Array<double, 1, 3> first_;  // in spacings
  Place size_;
  mutable std::unique_ptr<std::atomic<float>[]> samples_;  // NaN: not yet taken
};

}  // namespace musclewarp
