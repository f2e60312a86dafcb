// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/bodies_along.h"

#include <algorithm>

#include "musclewarp/base/infinity.h"

namespace musclewarp {

std::vector<std::string> BodiesAlong(const Points& line,
                                     const std::string& origin,
                                     const std::string& insertion,
                                     const std::vector<BodySurface>& bodies) {
  const int count = static_cast<int>(line.rows());
  const auto distances_to = [&](const std::string& name) {
    Eigen::VectorXd distances = Eigen::VectorXd::Zero(count);
    for (const BodySurface& body : bodies) {
      if (body.body != name) continue;
      for (int i = 0; i < count; ++i) distances[i] = body.Distance(line.row(i));
    }
    return distances;
  };
  const Eigen::VectorXd to_origin = distances_to(origin);
  const Eigen::VectorXd to_insertion = distances_to(insertion);
  std::vector<std::string> best;
  double least = kInfinity;
  for (const BodySurface& between : bodies) {
    const Eigen::VectorXd to_between = distances_to(between.body);
    // Points before i follow the origin, points from k on the insertion.
    for (int i = 1; i < count; ++i) {
      for (int k = i; k < count; ++k) {
        const double sum = to_origin.head(i).sum() +
                           to_between.segment(i, k - i).sum() +
                           to_insertion.tail(count - k).sum();
        if (sum >= least) continue;
        least = sum;
        best.assign(count, between.body);
        std::fill(best.begin(), best.begin() + i, origin);
        std::fill(best.begin() + k, best.end(), insertion);
      }
    }
  }
  return best;
}

}  // namespace musclewarp
