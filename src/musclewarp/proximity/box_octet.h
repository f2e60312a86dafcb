// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/box.h"

namespace musclewarp {

// Up to eight boxes side by side, so that the processor compares a point with
// several of them at once. Boxes are in single precision, rounded outward.
struct BoxOctet {
  static constexpr int kSize = 8;
  using Values = Eigen::Array<float, kSize, 1>;       // by lane
  using Coordinates = Eigen::Array<float, kSize, 3>;  // by lane and axis

  Coordinates lower = Coordinates::Zero();
  Coordinates upper = Coordinates::Zero();
  int count = 0;  // the lanes in use

  // Precondition: 0 <= lane < kSize.
  void SetBox(int lane, const Box3& box);
};

// A point, in single precision rounded down and up.
struct OctetQuery {
  explicit OctetQuery(const Eigen::RowVector3d& point);

  Eigen::Array3f lower;
  Eigen::Array3f upper;
};

// Returns by lane a lower bound of the squared distance of a point to the box,
// mm^2, 0 within it. It falls short by no more than rounding explains.
inline BoxOctet::Values BoundSquaredDistances(const BoxOctet& octet,
                                              const OctetQuery& query) {
  // Squares, sums and differences round six times, by half a unit each.
  constexpr float kShortfall = 1 - 0x1p-20F;
  BoxOctet::Values sums = BoxOctet::Values::Zero();
  for (int k = 0; k < 3; ++k) {
    sums += (octet.lower.col(k) - query.upper[k])
                .max(query.lower[k] - octet.upper.col(k))
                .max(0)
                .square();
  }
  return kShortfall * sums;
}

}  // namespace musclewarp
