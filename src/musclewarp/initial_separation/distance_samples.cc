// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/distance_samples.h"

#include <glog/logging.h>

#include <limits>
#include <utility>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr std::int64_t kBlock = 4;  // points along an edge of a block

}  // namespace

DistanceSamples::DistanceSamples(SignedDistanceFunction distance,
                                 const Box3& box,
                                 double spacing)
    : distance_(std::move(distance)), spacing_(spacing) {
  CHECK_GT(spacing, 0);
  for (int k = 0; k < 3; ++k) {
    first_[k] =
        static_cast<std::int64_t>(std::floor(box.lower[k] / spacing)) - 1;
    size_[k] = static_cast<std::int64_t>(std::ceil(box.upper[k] / spacing)) +
               2 - first_[k];
  }
  blocks_ = (size_ + kBlock - 1) / kBlock;
  values_ = Unknown(size_.prod());
  middles_ = Unknown(blocks_.prod());
}

void DistanceSamples::SampleAll() {
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < size_.prod(); ++i) value(i);
}

RowVector3d DistanceSamples::Position(std::int64_t index) const {
  return Position(PlaceOf(index));
}

std::int64_t DistanceSamples::NearestTo(const RowVector3d& p) const {
  Place at;
  for (int k = 0; k < 3; ++k) {
    at[k] = std::llround(p[k] / spacing_) - first_[k];
    if (at[k] < 0 || at[k] >= size_[k]) return -1;
  }
  return IndexOf(at);
}

DistanceSamples::Values DistanceSamples::Unknown(std::int64_t count) {
  Values values(new std::atomic<double>[count]);
  for (std::int64_t i = 0; i < count; ++i) {
    values[i].store(std::numeric_limits<double>::quiet_NaN(),
                    std::memory_order_relaxed);
  }
  return values;
}

DistanceSamples::Place DistanceSamples::PlaceOf(std::int64_t index) const {
  return {index % size_[0],
          index / size_[0] % size_[1],
          index / (size_[0] * size_[1])};
}

RowVector3d DistanceSamples::Position(const Place& at) const {
  return spacing_ * (first_ + at).cast<double>().matrix();
}

double DistanceSamples::Sample(std::int64_t index) const {
  const Place at = PlaceOf(index);
  const Place block = at / kBlock;
  const RowVector3d low = Position(kBlock * block);
  const RowVector3d high =
      Position(Place((kBlock * block + kBlock).min(size_) - 1));
  const RowVector3d middle = (low + high) / 2;
  std::atomic<double>& known =
      middles_[block[0] + blocks_[0] * (block[1] + blocks_[1] * block[2])];
  double at_middle = known.load(std::memory_order_relaxed);
  if (std::isnan(at_middle)) {
    at_middle = distance_(middle);
    known.store(at_middle, std::memory_order_relaxed);
  }
  const RowVector3d p = Position(at);
  const bool is_far =
      std::abs(at_middle) > (high - low).norm() / 2 + 2 * spacing_;
  const double value =
      is_far ? at_middle - std::copysign((p - middle).norm(), at_middle)
             : distance_(p);
  values_[index].store(value, std::memory_order_relaxed);
  return value;
}

}  // namespace musclewarp
