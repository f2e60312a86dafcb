// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/push_chains.h"

#include <Eigen/Core>
#include <algorithm>

namespace musclewarp {
namespace {

constexpr double kApart = -1;  // of muscles that do not push each other

// Walks from the pushed muscle back along all chains.
class Walker {
 public:
  Walker(int num_muscles,
         const std::vector<PairDepth>& overlaps,
         const std::vector<std::pair<int, int>>& touching,
         int max_length)
      : overlaps_(overlaps),
        between_(Eigen::MatrixXd::Constant(num_muscles, num_muscles, kApart)),
        max_length_(max_length) {
    for (const auto& [a, b] : touching) Link(a, b, 0);
    for (const PairDepth& overlap : overlaps) {
      if (!overlap.is_bone) Link(overlap.a, overlap.b, overlap.depth);
    }
  }

  PushChain FarthestOf(int muscle) {
    farthest_ = {kApart, {}};
    chain_ = {muscle};
    Visit(0);
    std::reverse(farthest_.muscles.begin(), farthest_.muscles.end());
    return farthest_;
  }

 private:
  void Link(int a, int b, double depth) {
    between_(a, b) = between_(b, a) = std::max(between_(a, b), depth);
  }

  bool IsInChain(int muscle) const {
    return std::find(chain_.begin(), chain_.end(), muscle) != chain_.end();
  }

  // The deepest overlap of the first muscle with anything outside the chain, or
  // with anything if it is alone.
  double DepthOfFirst() const {
    const int first = chain_.back();
    double depth = 0;
    for (const PairDepth& overlap : overlaps_) {
      const bool is_a = overlap.a == first;
      if (!is_a && (overlap.is_bone || overlap.b != first)) continue;
      const int other = is_a ? overlap.b : overlap.a;
      if (!overlap.is_bone && chain_.size() > 1 && IsInChain(other)) continue;
      depth = std::max(depth, overlap.depth);
    }
    return depth;
  }

  // `depth`: of the overlaps between the muscles of the chain.
  void Visit(double depth) {
    const double whole = depth + DepthOfFirst();
    if (whole > farthest_.depth) farthest_ = {whole, chain_};
    if (static_cast<int>(chain_.size()) == max_length_) return;
    const int first = chain_.back();
    for (int next = 0; next < between_.rows(); ++next) {
      if (between_(first, next) == kApart || IsInChain(next)) continue;
      chain_.push_back(next);
      Visit(depth + between_(first, next));
      chain_.pop_back();
    }
  }

  const std::vector<PairDepth>& overlaps_;
  Eigen::MatrixXd between_;
  int max_length_;
  std::vector<int> chain_;  // the pushed muscle first
  PushChain farthest_;
};

}  // namespace

std::vector<PushChain> FarthestPushes(
    int num_muscles,
    const std::vector<PairDepth>& overlaps,
    const std::vector<std::pair<int, int>>& touching,
    int max_length) {
  Walker walker(num_muscles, overlaps, touching, max_length);
  std::vector<PushChain> pushes;
  for (int i = 0; i < num_muscles; ++i) pushes.push_back(walker.FarthestOf(i));
  return pushes;
}

}  // namespace musclewarp
