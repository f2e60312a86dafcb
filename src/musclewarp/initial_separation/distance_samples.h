// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>

#include "musclewarp/mesh/box.h"

namespace musclewarp {

// A function of a place, mm, that is negative inside a region and changes by no
// more than the way between two places, as a signed distance does.
using SignedDistanceFunction = std::function<double(const Eigen::RowVector3d&)>;

// The values of a signed distance at the points of a regular lattice: the
// multiples of a spacing. A value is computed when it is asked for first.
// Blocks of the lattice that are far from the border of the region are not
// sampled point by point, so that the cost grows with the area of the border
// rather than with the volume of the box.
class DistanceSamples {
 public:
  // Three numbers that count points of the lattice along the axes.
  using Place = Eigen::Array<std::int64_t, 1, 3>;

  // Samples a function at the multiples of `spacing` (mm) in a box and one
  // beyond. What the function refers to has to outlive the samples.
  // Precondition (CHECKed): the spacing is above zero.
  DistanceSamples(SignedDistanceFunction distance,
                  const Box3& box,
                  double spacing);

  // Returns a value with the sign of the function and no larger magnitude. It
  // is the value of the function within two spacings of the border, and above
  // that in magnitude elsewhere. May be called from several threads, which then
  // call the function.
  double value(std::int64_t index) const {
    const double known = values_[index].load(std::memory_order_relaxed);
    return std::isnan(known) ? Sample(index) : known;
  }

  // Computes all values, on several threads.
  void SampleAll();

  // The points along each axis, and the index of a point; x runs fastest.
  const Place& size() const { return size_; }
  std::int64_t IndexOf(const Place& at) const {
    return at[0] + size_[0] * (at[1] + size_[1] * at[2]);
  }

  // Returns the place of a point, mm.
  Eigen::RowVector3d Position(std::int64_t index) const;

  // Returns the index of the point nearest to `p`, or -1 if `p` is beyond the
  // lattice by more than half a spacing.
  std::int64_t NearestTo(const Eigen::RowVector3d& p) const;

 private:
  // Computed when needed, and NaN before. Threads may compute a value at the
  // same time: it is the same for all of them.
  using Values = std::unique_ptr<std::atomic<double>[]>;
  static Values Unknown(std::int64_t count);

  Place PlaceOf(std::int64_t index) const;
  Eigen::RowVector3d Position(const Place& at) const;
  double Sample(std::int64_t index) const;

  SignedDistanceFunction distance_;
  double spacing_;
  Place first_, size_, blocks_;
  Values values_;
  Values middles_;  // of blocks, by block
};

}  // namespace musclewarp
