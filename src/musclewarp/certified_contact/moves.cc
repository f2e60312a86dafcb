// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/moves.h"

#include <algorithm>

namespace musclewarp {
namespace {

void AppendMoves(const Points& a, const Points& b, std::vector<double>* moves) {
  for (Eigen::Index v = 0; v < a.rows(); ++v) {
    moves->push_back((a.row(v) - b.row(v)).norm());
  }
}

// Returns the largest move without the fraction `share` of the largest ones.
double LargestOfMost(double share, std::vector<double>* moves) {
  if (moves->empty()) return 0;
  const auto most =
      moves->end() - 1 -
      static_cast<int>(share * static_cast<double>(moves->size()));
  std::nth_element(moves->begin(), most, moves->end());
  return *most;
}

}  // namespace

double MoveOfMost(const std::vector<Points>& a,
                  const std::vector<Points>& b,
                  double share) {
  std::vector<double> moves;
  for (size_t i = 0; i < a.size(); ++i) AppendMoves(a[i], b[i], &moves);
  return LargestOfMost(share, &moves);
}

double MoveOfMostMoved(const std::vector<Points>& a,
                       const std::vector<Points>& b,
                       double share) {
  double largest = 0;
  std::vector<double> moves;
  for (size_t i = 0; i < a.size(); ++i) {
    moves.clear();
    AppendMoves(a[i], b[i], &moves);
    largest = std::max(largest, LargestOfMost(share, &moves));
  }
  return largest;
}

}  // namespace musclewarp
