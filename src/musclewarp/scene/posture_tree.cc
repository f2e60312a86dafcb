// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/posture_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace musclewarp {
namespace {

// Returns the posture from which each is reached, -1 for rest.
std::vector<int> NearestTowardsRest(const Eigen::RowVectorXd& rest,
                                    const Eigen::MatrixXd& postures) {
  const auto count = static_cast<int>(postures.rows());
  const Eigen::VectorXd from_rest =
      (postures.rowwise() - rest).rowwise().squaredNorm();
  std::vector<int> outwards(count);
  std::iota(outwards.begin(), outwards.end(), 0);
  std::stable_sort(outwards.begin(), outwards.end(), [&](int a, int b) {
    return from_rest[a] < from_rest[b];
  });
  std::vector<int> parents(count, -1);
  for (int i = 0; i < count; ++i) {
    const int posture = outwards[i];
    double nearest = from_rest[posture];
    for (int j = 0; j < i; ++j) {
      const double distance =
          (postures.row(posture) - postures.row(outwards[j])).squaredNorm();
      if (distance >= nearest) continue;
      nearest = distance;
      parents[posture] = outwards[j];
    }
  }
  return parents;
}

}  // namespace

PostureTree TreeFrom(const Eigen::RowVectorXd& rest,
                     const Eigen::MatrixXd& postures) {
  const std::vector<int> parents = NearestTowardsRest(rest, postures);
  const auto count = static_cast<int>(parents.size());
  std::vector<std::vector<int>> children(count);
  // The last child first, as the stack below reverses them.
  std::vector<std::pair<int, int>> waiting;  // posture, place of its parent
  for (int i = count - 1; i >= 0; --i) {
    if (parents[i] >= 0) {
      children[parents[i]].push_back(i);
    } else {
      waiting.emplace_back(i, -1);
    }
  }
  PostureTree tree;
  while (!waiting.empty()) {
    const auto [posture, parent] = waiting.back();
    waiting.pop_back();
    const auto place = static_cast<int>(tree.order.size());
    tree.order.push_back(posture);
    tree.reached_from.push_back(parent);
    for (const int child : children[posture]) {
      waiting.emplace_back(child, place);
    }
  }
  return tree;
}

}  // namespace musclewarp
