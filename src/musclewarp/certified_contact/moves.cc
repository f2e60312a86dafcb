// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/moves.h"

#include <algorithm>

namespace musclewarp {

double MoveOfMost(const std::vector<Points>& a,
                  const std::vector<Points>& b,
                  double share) {
  std::vector<double> moves;
  for (size_t i = 0; i < a.size(); ++i) {
    for (Eigen::Index v = 0; v < a[i].rows(); ++v) {
      moves.push_back((a[i].row(v) - b[i].row(v)).norm());
    }
  }
  if (moves.empty()) return 0;
  const auto most = moves.end() - 1 -
                    static_cast<int>(share * static_cast<double>(moves.size()));
  std::nth_element(moves.begin(), most, moves.end());
  return *most;
}

double MoveOfMostMoved(const std::vector<Points>& a,
                       const std::vector<Points>& b,
                       double share) {
  double largest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, MoveOfMost({a[i]}, {b[i]}, share));
  }
  return largest;
}

}  // namespace musclewarp
