// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/moves.h"

#include <algorithm>

namespace musclewarp {
namespace {

// Returns the largest move without the fraction `share` of the largest ones.
double MoveOfMostPoints(const Points& a, const Points& b, double share) {
  if (a.rows() == 0) return 0;
  std::vector<double> moves(a.rows());
  for (Eigen::Index v = 0; v < a.rows(); ++v) {
    moves[v] = (a.row(v) - b.row(v)).norm();
  }
  const auto most = moves.end() - 1 -
                    static_cast<int>(share * static_cast<double>(moves.size()));
  std::nth_element(moves.begin(), most, moves.end());
  return *most;
}

}  // namespace

std::vector<double> MovesOfMost(const std::vector<Points>& a,
                                const std::vector<Points>& b,
                                double share) {
  std::vector<double> moves(a.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < a.size(); ++i) {
    moves[i] = MoveOfMostPoints(a[i], b[i], share);
  }
  return moves;
}

double MoveOfMostMoved(const std::vector<Points>& a,
                       const std::vector<Points>& b,
                       double share) {
  const std::vector<double> moves = MovesOfMost(a, b, share);
  return moves.empty() ? 0 : *std::max_element(moves.begin(), moves.end());
}

}  // namespace musclewarp
