// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/growth_search.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

// The relative accuracy of the volume, and the largest number of steps.
constexpr double kAccuracy = 2e-3;
constexpr int kMostSteps = 14;

}  // namespace

double SearchGrowth(const std::function<double(double)>& volume_at,
                    double left,
                    double volume,
                    double reach,
                    double t) {
  double low = 0, high = reach;
  double low_volume = left, high_volume = kInfinity;
  double tried = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    tried = t;
    const double now = volume_at(t);
    if (std::abs(now - volume) < kAccuracy * volume) break;
    if (now < volume) {
      if (t == reach) break;
      low = t;
      low_volume = now;
    } else {
      high = t;
      high_volume = now;
    }
    if (high_volume == kInfinity) {
      t = std::min(1.5 * t, reach);
      continue;
    }
    const double part = (volume - low_volume) / (high_volume - low_volume);
    t = low + std::clamp(part, 0.1, 0.9) * (high - low);
  }
  return tried;
}

}  // namespace musclewarp
