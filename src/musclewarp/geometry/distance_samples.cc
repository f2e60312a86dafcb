// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/distance_samples.h"

#include <glog/logging.h>

#include <cmath>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr std::int64_t kBlock = 8;  // points along an edge of a block

}  // namespace

DistanceSamples::DistanceSamples(const SignedDistanceFunction& distance,
                                 const Box3& box,
                                 double spacing)
    : spacing_(spacing) {
  CHECK_GT(spacing, 0);
  for (int k = 0; k < 3; ++k) {
    first_[k] =
        static_cast<std::int64_t>(std::floor(box.lower[k] / spacing)) - 1;
    size_[k] = static_cast<std::int64_t>(std::ceil(box.upper[k] / spacing)) +
               2 - first_[k];
  }
  values_.resize(size_.prod());
  const Place blocks = (size_ + kBlock - 1) / kBlock;
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t b = 0; b < blocks.prod(); ++b) {
    FillBlock(distance,
              kBlock * Place(b % blocks[0],
                             b / blocks[0] % blocks[1],
                             b / (blocks[0] * blocks[1])));
  }
}

RowVector3d DistanceSamples::Position(std::int64_t index) const {
  const Place at(index % size_[0],
                 index / size_[0] % size_[1],
                 index / (size_[0] * size_[1]));
  return spacing_ * (first_ + at).cast<double>().matrix();
}

std::int64_t DistanceSamples::NearestTo(const RowVector3d& p) const {
  Place at;
  for (int k = 0; k < 3; ++k) {
    at[k] = std::llround(p[k] / spacing_) - first_[k];
    if (at[k] < 0 || at[k] >= size_[k]) return -1;
  }
  return IndexOf(at);
}

void DistanceSamples::FillBlock(const SignedDistanceFunction& distance,
                                const Place& first) {
  const Place last = (first + kBlock).min(size_);
  const RowVector3d low = Position(IndexOf(first));
  const RowVector3d high = Position(IndexOf(last - 1));
  const RowVector3d middle = (low + high) / 2;
  const double at_middle = distance(middle);
  const bool is_far =
      std::abs(at_middle) > (high - low).norm() / 2 + 2 * spacing_;
  for (std::int64_t z = first[2]; z < last[2]; ++z) {
    for (std::int64_t y = first[1]; y < last[1]; ++y) {
      for (std::int64_t x = first[0]; x < last[0]; ++x) {
        const std::int64_t index = IndexOf({x, y, z});
        const RowVector3d p = Position(index);
        values_[index] =
            is_far ? at_middle - std::copysign((p - middle).norm(), at_middle)
                   : distance(p);
      }
    }
  }
}

}  // namespace musclewarp
