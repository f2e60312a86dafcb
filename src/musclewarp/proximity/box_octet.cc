// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/box_octet.h"

#include <cmath>

namespace musclewarp {
namespace {

// Two units in the last place of single precision, and more than its smallest
// number: conversion rounds by half a unit at most.
double RoundingOf(double x) { return 0x1p-22 * std::abs(x) + 1e-37; }

float RoundedDown(double x) { return static_cast<float>(x - RoundingOf(x)); }
float RoundedUp(double x) { return static_cast<float>(x + RoundingOf(x)); }

}  // namespace

void BoxOctet::SetBox(int lane, const Box3& box) {
  for (int k = 0; k < 3; ++k) {
    lower(lane, k) = RoundedDown(box.lower[k]);
    upper(lane, k) = RoundedUp(box.upper[k]);
  }
}

OctetQuery::OctetQuery(const Eigen::RowVector3d& point) {
  for (int k = 0; k < 3; ++k) {
    lower[k] = RoundedDown(point[k]);
    upper[k] = RoundedUp(point[k]);
  }
}

}  // namespace musclewarp
