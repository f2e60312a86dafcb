// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/box_octet.h"

#include <cmath>

#include "musclewarp/base/wide_registers.h"

namespace musclewarp {
namespace {

// Two units in the last place of single precision, and more than its smallest
// number: conversion rounds by half a unit at most.
double RoundingOf(double x) { return 0x1p-22 * std::abs(x) + 1e-37; }

float RoundedDown(double x) { return static_cast<float>(x - RoundingOf(x)); }
float RoundedUp(double x) { return static_cast<float>(x + RoundingOf(x)); }

// Squares, sums and differences round six times, by half a unit each.
constexpr float kShortfall = 1 - 0x1p-20F;

}  // namespace

void BoxOctet::SetBox(int lane, const Box3& box) {
  for (int k = 0; k < 3; ++k) {
    lower[k][lane] = RoundedDown(box.lower[k]);
    upper[k][lane] = RoundedUp(box.upper[k]);
  }
}

OctetQuery::OctetQuery(const Eigen::RowVector3d& point) {
  for (int k = 0; k < 3; ++k) {
    lower[k] = RoundedDown(point[k]);
    upper[k] = RoundedUp(point[k]);
  }
}

MUSCLEWARP_WIDE void BoundSquaredDistances(const BoxOctet& octet,
                                           const OctetQuery& query,
                                           float (&bounds)[BoxOctet::kSize]) {
  float sums[BoxOctet::kSize] = {};
  for (int k = 0; k < 3; ++k) {
    const float low = query.lower[k], high = query.upper[k];
#pragma omp simd
    for (int i = 0; i < BoxOctet::kSize; ++i) {
      const float below = octet.lower[k][i] - high;
      const float above = low - octet.upper[k][i];
      const float aside = below > above ? below : above;
      const float distance = aside > 0 ? aside : 0;
      sums[i] += distance * distance;
    }
  }
#pragma omp simd
  for (int i = 0; i < BoxOctet::kSize; ++i) bounds[i] = kShortfall * sums[i];
}

}  // namespace musclewarp
