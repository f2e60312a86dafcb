// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/base/infinity.h"

namespace musclewarp {

// Tells from the moves of settling steps when further steps lead nowhere:
// squeezed vertices move to and fro for ever.
//
//   SettlingProgress progress(/*reach=*/1);
//   do {
//     progress.Add(Settle());
//   } while (!progress.IsStalled());
class SettlingProgress {
 public:
  // `reach`: a longer move, mm, is one towards a distant goal.
  explicit SettlingProgress(double reach) : reach_(reach) {}

  // `move`: by how much a step moved muscles, mm.
  void Add(double move) {
    if (move < kLess * least_ || move > reach_) {
      least_ = move;
      steps_since_least_ = 0;
    } else {
      ++steps_since_least_;
    }
  }

  // Returns true if none of the last three steps moved muscles by less than 0.9
  // of the least move before them.
  bool IsStalled() const { return steps_since_least_ >= kPatience; }

 private:
  static constexpr double kLess = 0.9;
  static constexpr int kPatience = 3;

  double reach_;
  double least_ = kInfinity;  // mm
  int steps_since_least_ = 0;
};

}  // namespace musclewarp
