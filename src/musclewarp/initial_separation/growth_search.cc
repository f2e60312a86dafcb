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

// Returns a point of an interval, by its share from the lower end; a tenth of
// the interval stays on either side.
double Between(double low, double high, double share) {
  return low + std::clamp(share, 0.1, 0.9) * (high - low);
}

}  // namespace

GrowthGuess SearchGrowth(const std::function<double(double)>& volume_at,
                         double left,
                         double volume,
                         double reach,
                         const GrowthGuess& first) {
  double low = 0, high = reach;
  double low_volume = left, high_volume = kInfinity;
  GrowthGuess last;
  double last_volume = left;
  double t = first.t;
  for (int step = 0; step < kMostSteps; ++step) {
    const double now = volume_at(t);
    const bool follows_slope = step == 0 && first.slope > 0;
    const double chord = (now - last_volume) / (t - last.t);
    last = {t, follows_slope ? first.slope : chord};
    last_volume = now;
    if (std::abs(now - volume) < kAccuracy * volume) break;
    if (now < volume) {
      if (t == reach) break;
      low = t;
      low_volume = now;
    } else {
      high = t;
      high_volume = now;
    }
    if (follows_slope) {
      const double next = t + (volume - now) / last.slope;
      t = std::clamp(next, t / 1.5, std::min(1.5 * t, reach));
    } else if (high_volume == kInfinity) {
      t = std::min(1.5 * t, reach);
    } else {
      t = Between(
          low, high, (volume - low_volume) / (high_volume - low_volume));
    }
  }
  return last;
}

}  // namespace musclewarp
