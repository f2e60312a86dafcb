// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/settling_muscles.h"

#include <glog/logging.h>

#include <algorithm>

namespace musclewarp {
namespace {

// A muscle moves to and fro if none of so many steps moved it by less than this
// fraction of the least move before.
constexpr int kPatience = 3;
constexpr double kLess = 0.9;

// A muscle that has settled counts as unsettled again if others make it move by
// as much, mm, and by no less than the tolerance: what goes to and fro between
// neighbours would otherwise never end.
constexpr double kUnsettling = 0.3;

}  // namespace

std::vector<char> SettlingMuscles::Still() const {
  std::vector<char> is_still;
  if (all_move_ || AreSettled()) return is_still;
  for (const Muscle& muscle : muscles_) {
    is_still.push_back(!muscle.is_unsettled);
  }
  return is_still;
}

void SettlingMuscles::Add(const std::vector<double>& moves,
                          const std::vector<char>& is_still) {
  CHECK_EQ(moves.size(), muscles_.size());
  num_unsettled_ = 0;
  for (size_t i = 0; i < muscles_.size(); ++i) {
    if (is_still.empty() || !is_still[i]) AddMove(moves[i], &muscles_[i]);
    num_unsettled_ += muscles_[i].is_unsettled;
  }
  all_move_ = false;
}

void SettlingMuscles::MoveOnly(const std::vector<char>& is_unsettled) {
  CHECK_EQ(is_unsettled.size(), muscles_.size());
  num_unsettled_ = 0;
  for (size_t i = 0; i < muscles_.size(); ++i) {
    muscles_[i].is_unsettled = is_unsettled[i];
    num_unsettled_ += is_unsettled[i];
  }
  all_move_ = num_unsettled_ == 0;
}

void SettlingMuscles::AddMove(double move, Muscle* muscle) const {
  if (move < kLess * muscle->least || move > reach_) {
    muscle->least = move;
    muscle->steps_since_least = 0;
  } else {
    ++muscle->steps_since_least;
  }
  const double limit =
      muscle->is_unsettled ? tolerance_ : std::max(tolerance_, kUnsettling);
  muscle->is_unsettled = move >= limit && muscle->steps_since_least < kPatience;
}

}  // namespace musclewarp
