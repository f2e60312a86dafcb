// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "musclewarp/mesh/box.h"

namespace musclewarp {

// A function of a position (mm) that is negative inside a region and has a
// Lipschitz constant of at most 1, as signed distances have.
using SignedDistanceFunction = std::function<double(const Eigen::RowVector3d&)>;

// The values of a signed distance at the points of a regular lattice: the
// multiples of a spacing. Values are computed on first use. Blocks of the
// lattice that are far from the boundary of the region are not sampled point by
// point, so that the cost grows with the area of the boundary rather than with
// the volume of the box.
class DistanceSamples {
 public:
  // Three integers: numbers of lattice points along the axes.
  using Place = Eigen::Array<std::int64_t, 1, 3>;

  // Samples a function at the multiples of `spacing` (mm) in a box, and one
  // further multiple on each side. Objects to which the function refers must
  // outlive the samples. Precondition (CHECKed): the spacing is above zero.
  DistanceSamples(SignedDistanceFunction distance,
                  const Box3& box,
                  double spacing);

  // Returns a value with the sign of the function and at most its magnitude:
  // the value of the function within two spacings of the boundary, and a value
  // of more than two spacings in magnitude elsewhere. May be called from
  // several threads, which then call the function.
  double value(std::int64_t index) const {
    const double known = values_[index].load(std::memory_order_relaxed);
    return std::isnan(known) ? Sample(index) : known;
  }

  // Computes all values, on several threads.
  void SampleAll();

  // The number of points along each axis, and the index of a point; x changes
  // fastest.
  const Place& size() const { return size_; }
  std::int64_t IndexOf(const Place& at) const {
    return at[0] + size_[0] * (at[1] + size_[1] * at[2]);
  }

  // Returns the position of a lattice point, mm.
  Eigen::RowVector3d Position(std::int64_t index) const;

  // Returns the index of the lattice point nearest to `p` (mm), or -1 if `p` is
  // more than half a spacing outside the lattice.
  std::int64_t NearestTo(const Eigen::RowVector3d& p) const;

 private:
  // Values are NaN until they are computed. Several threads may compute the
  // same value at the same time, with the same result.
  using Values = std::unique_ptr<std::atomic<double>[]>;
  static Values Unknown(std::int64_t count);

  // Blocks of the lattice, which share the value at their centre.
  struct Blocks {
    Blocks(const Place& lattice, std::int64_t points);

    std::int64_t edge;  // points along it
    Place count;
    Values middles;
  };

  Place PlaceOf(std::int64_t index) const;
  Eigen::RowVector3d Position(const Place& at) const;
  double Sample(std::int64_t index) const;

  // Returns the value of a point if its block is far from the boundary.
  std::optional<double> FarValue(const Place& at, const Blocks& blocks) const;

  SignedDistanceFunction distance_;
  double spacing_;
  Place first_, size_;
  Values values_;
  std::vector<Blocks> blocks_;  // the largest first
};

}  // namespace musclewarp
