// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/distance_samples.h"

#include <glog/logging.h>

#include <limits>
#include <utility>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Points along the edges of blocks, and of blocks within them.
constexpr std::int64_t kEdges[] = {4, 2};

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
  values_ = Unknown(size_.prod());
  for (const std::int64_t edge : kEdges) blocks_.emplace_back(size_, edge);
}

DistanceSamples::Blocks::Blocks(const Place& lattice, std::int64_t points)
    : edge(points),
      count((lattice + edge - 1) / edge),
      middles(Unknown(count.prod())) {}

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

std::optional<double> DistanceSamples::FarValue(const Place& at,
                                                const Blocks& blocks) const {
  const Place block = at / blocks.edge;
  const RowVector3d low = Position(blocks.edge * block);
  const RowVector3d high =
      Position(Place((blocks.edge * block + blocks.edge).min(size_) - 1));
  const RowVector3d middle = (low + high) / 2;
  std::atomic<double>& known =
      blocks.middles[block[0] +
                     blocks.count[0] * (block[1] + blocks.count[1] * block[2])];
  double at_middle = known.load(std::memory_order_relaxed);
  if (std::isnan(at_middle)) {
    at_middle = distance_(middle);
    known.store(at_middle, std::memory_order_relaxed);
  }
  if (std::abs(at_middle) <= (high - low).norm() / 2 + 2 * spacing_) {
    return std::nullopt;
  }
  return at_middle - std::copysign((Position(at) - middle).norm(), at_middle);
}

double DistanceSamples::Sample(std::int64_t index) const {
  const Place at = PlaceOf(index);
  std::optional<double> value;
  for (const Blocks& blocks : blocks_) {
    if (!value) value = FarValue(at, blocks);
  }
  if (!value) value = distance_(Position(at));
  values_[index].store(*value, std::memory_order_relaxed);
  return *value;
}

}  // namespace musclewarp
