// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/box.h"

namespace musclewarp {

// Up to eight boxes side by side, so that the processor compares a point with
// all of them at once. Boxes are in single precision, rounded outward.
struct BoxOctet {
  static constexpr int kSize = 8;

  float lower[3][kSize];
  float upper[3][kSize];
  int count = 0;  // the boxes in use; what follows is undefined

  // Precondition: 0 <= lane < kSize.
  void SetBox(int lane, const Box3& box);
};

// A point, in single precision rounded down and up.
struct OctetQuery {
  explicit OctetQuery(const Eigen::RowVector3d& point);
  float lower[3];
  float upper[3];
};

// Sets by lane a lower bound of the squared distance of a point to the box, 0
// within it. It falls short by no more than rounding explains.
void BoundSquaredDistances(const BoxOctet& octet,
                           const OctetQuery& query,
                           float (&bounds)[BoxOctet::kSize]);

}  // namespace musclewarp
