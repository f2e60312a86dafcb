// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "musclewarp/base/infinity.h"

namespace musclewarp {

// Tells from the moves of settling steps which muscles have settled: those that
// have come to rest, and those that move to and fro, as squeezed ones do for
// ever. While others settle, they stand still.
//
//   SettlingMuscles settling(num_muscles, /*tolerance=*/0.1, /*reach=*/1);
//   while (!settling.AreSettled()) {
//     const std::vector<char> is_still = settling.Still();
//     settling.Add(MovesOfStep(is_still), is_still);
//   }
class SettlingMuscles {
 public:
  // A muscle has come to rest if a step moves it by less than `tolerance`, mm.
  // A move beyond `reach`, mm, is one towards a distant goal.
  SettlingMuscles(std::size_t num_muscles, double tolerance, double reach)
      : tolerance_(tolerance), reach_(reach), muscles_(num_muscles) {}

  // Returns by muscle whether it may stand still in the next step; empty if all
  // muscles are to move.
  std::vector<char> Still() const;

  // Records a step in which muscles moved by these distances, by muscle, mm.
  // `is_still`: those that stood still; empty if all moved.
  void Add(const std::vector<double>& moves, const std::vector<char>& is_still);

  bool AreSettled() const { return num_unsettled_ == 0; }

  // Has all muscles move in the next step.
  void MoveAll() { all_move_ = true; }

  // Has only these muscles move in the next step, or all if there are none.
  void MoveOnly(const std::vector<char>& is_unsettled);

 private:
  struct Muscle {
    bool is_unsettled = true;
    double least = kInfinity;   // of all moves, mm
    int steps_since_least = 0;  // without one that is clearly less
  };

  void AddMove(double move, Muscle* muscle) const;

  double tolerance_, reach_;  // mm
  std::vector<Muscle> muscles_;
  bool all_move_ = true;
  int num_unsettled_ = 1;  // until the first step has told
};

}  // namespace musclewarp
