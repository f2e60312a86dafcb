// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/posture_samples.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "musclewarp/base/random_draws.h"

namespace musclewarp {
Eigen::MatrixXd LatinHypercube(int count, int dimensions, std::uint32_t seed) {
  RandomDraws draws(seed);
  Eigen::MatrixXd samples(count, dimensions);
  std::vector<int> intervals(count);
  for (int k = 0; k < dimensions; ++k) {
    std::iota(intervals.begin(), intervals.end(), 0);
    for (int i = count - 1; i > 0; --i) {
      std::swap(intervals[i], intervals[draws.Integer(0, i)]);
    }
    for (int i = 0; i < count; ++i) {
      samples(i, k) = (intervals[i] + draws.Uniform(0, 1)) / count;
    }
  }
  return samples;
}

Eigen::MatrixXd GridSamples(const std::vector<int>& counts) {
  Eigen::Index rows = 1;
  for (const int count : counts) rows *= count;
  Eigen::MatrixXd samples(rows, static_cast<Eigen::Index>(counts.size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    Eigen::Index rest = i;
    for (Eigen::Index k = samples.cols() - 1; k >= 0; --k) {
      const Eigen::Index place = rest % counts[k];
      rest /= counts[k];
      samples(i, k) = counts[k] == 1 ? 0.5
                                     : static_cast<double>(place) /
                                           static_cast<double>(counts[k] - 1);
    }
  }
  return samples;
}

std::vector<int> GridCounts(const std::vector<double>& widths, int most) {
  std::vector<int> counts(widths.size(), 2);
  const auto product = [&] {
    std::int64_t points = 1;
    // Stays below the square of the largest int.
    for (const int count : counts) {
      points = std::min<std::int64_t>(points * count, std::int64_t{most} + 1);
    }
    return points;
  };
  if (product() > most) return {};
  // The coordinate with the widest spacing gets one more point, as long as it
  // fits, then the next one.
  std::vector<char> is_full(widths.size(), 0);
  while (true) {
    int widest = -1;
    double spacing = 0;
    for (size_t k = 0; k < widths.size(); ++k) {
      const double here = widths[k] / (counts[k] - 1);
      if (is_full[k] || here <= spacing) continue;
      spacing = here;
      widest = static_cast<int>(k);
    }
    if (widest < 0) return counts;
    ++counts[widest];
    if (product() <= most) continue;
    --counts[widest];
    is_full[widest] = 1;
  }
}

}  // namespace musclewarp
