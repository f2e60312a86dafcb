// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/distance_field.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

// The weights of three samples along an axis, by the number of derivatives: a
// quadratic B-spline at the offset f (-1/2 to 1/2) from the sample in the
// middle.
using SplineWeights = Eigen::Matrix3d;  // derivatives x samples

SplineWeights WeightsAt(double f) {
  SplineWeights weights;
  weights << 0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f,
      0.5 * (0.5 + f) * (0.5 + f),  //
      f - 0.5, -2 * f, f + 0.5,     //
      1, -2, 1;
  return weights;
}

}  // namespace

DistanceField::DistanceField(const TriangleSoup& surface,
                             double spacing,
                             double reach)
    : surface_(surface), spacing_(spacing), reach_(reach) {
  CHECK_GT(surface.triangles.rows(), 0);
  CHECK_GT(spacing, 0);
  constexpr double kMostSamples = 1 << 24;
  constexpr int kMargin = 2;  // samples, beside the reach
  double count = kInfinity;
  for (;; spacing_ *= 1.5) {
    Eigen::Array<double, 1, 3> size;
    for (int c = 0; c < 3; ++c) {
      const double more = std::ceil(reach / spacing_) + kMargin;
      first_[c] = std::floor(box().lower[c] / spacing_) - more;
      size[c] = std::ceil(box().upper[c] / spacing_) + more - first_[c] + 1;
    }
    count = size.prod();
    if (count > kMostSamples) continue;
    size_ = size.cast<int>();
    break;
  }
  samples_ = std::make_unique<std::atomic<float>[]>(static_cast<size_t>(count));
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    samples_[i].store(std::numeric_limits<float>::quiet_NaN(),
                      std::memory_order_relaxed);
  }
}

double DistanceField::Sample(const Place& at) const {
  std::atomic<float>& sample =
      samples_[(static_cast<size_t>(at[2]) * size_[1] + at[1]) * size_[0] +
               at[0]];
  const float known = sample.load(std::memory_order_relaxed);
  if (!std::isnan(known)) return known;
  const Eigen::RowVector3d place =
      spacing_ * (first_ + at.cast<double>()).matrix();
  const bool is_inside = surface_.winding().IsInside(place);
  const double far = is_inside ? kInfinity : reach_;
  const double distance =
      std::min(surface_.bvh().ClosestPoint(place, far).distance, far);
  const auto value = static_cast<float>(is_inside ? -distance : distance);
  sample.store(value, std::memory_order_relaxed);
  return value;
}

bool DistanceField::FindNearest(const Eigen::RowVector3d& place,
                                Place* sample,
                                std::array<double, 3>* offsets) const {
  for (int c = 0; c < 3; ++c) {
    const double at = place[c] / spacing_ - first_[c];
    if (!(at > 1 && at < size_[c] - 2)) return false;
    (*sample)[c] = static_cast<int>(at + 0.5);
    (*offsets)[c] = at - (*sample)[c];
  }
  return true;
}

double DistanceField::LowerBound(const Eigen::RowVector3d& place) const {
  Place nearest;
  std::array<double, 3> offsets;
  if (!FindNearest(place, &nearest, &offsets)) return 0;
  // The place is at most sqrt(3 / 4) spacings from the nearest sample. The
  // samples of the second place are so far from it in root mean square.
  return Sample(nearest) - 1.74 * spacing_;
}

bool DistanceField::IsBelow(double limit,
                            const Eigen::RowVector3d& place,
                            Value* value) const {
  Place base;
  std::array<double, 3> offsets;
  if (!FindNearest(place, &base, &offsets)) return false;
  // The spline is a mean of samples that are at most sqrt(3 / 2) spacings from
  // this one in root mean square, and distances differ by no more than that.
  if (Sample(base) > limit + 1.23 * spacing_) return false;
  const std::array<SplineWeights, 3> weights = {
      WeightsAt(offsets[0]), WeightsAt(offsets[1]), WeightsAt(offsets[2])};
  // Derivatives along y and z (rows), and along x (columns), of each layer.
  std::array<Eigen::Matrix3d, 3> layers;
  for (int z = 0; z < 3; ++z) {
    Eigen::Matrix3d samples;  // y x x
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) {
        samples(y, x) = Sample(base + Place(x - 1, y - 1, z - 1));
      }
    }
    layers[z] = weights[1] * samples * weights[0].transpose();
  }
  const std::array<double, 3> scale = {1, spacing_, spacing_ * spacing_};
  const auto derivative = [&](int x, int y, int z) {
    return (weights[2](z, 0) * layers[0](y, x) +
            weights[2](z, 1) * layers[1](y, x) +
            weights[2](z, 2) * layers[2](y, x)) /
           scale[x + y + z];
  };
  value->distance = derivative(0, 0, 0);
  if (!(value->distance < limit)) return false;
  value->gradient << derivative(1, 0, 0), derivative(0, 1, 0),
      derivative(0, 0, 1);
  const double xy = derivative(1, 1, 0), xz = derivative(1, 0, 1),
               yz = derivative(0, 1, 1);
  value->curvature << derivative(2, 0, 0), xy, xz,  //
      xy, derivative(0, 2, 0), yz,                  //
      xz, yz, derivative(0, 0, 2);
  return true;
}

}  // namespace musclewarp
