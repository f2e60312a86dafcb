// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/step_length.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

// Lengths that differ by less than this fraction are equal up to rounding.
constexpr double kRounding = 0.01;

// The targeted push as a fraction of the largest admissible push.
constexpr double kAim = 0.8;

}  // namespace

StepLength::StepLength(const StepLengthOptions& options)
    : options_(options), length_(options.longest) {}

double StepLength::NextFrom(double at) {
  const double steps = std::max(1.0, std::ceil((1 - at) / length_ - kRounding));
  length_ = (1 - at) / steps;
  return steps == 1 ? 1 : at + length_;
}

double StepLength::max_push() const {
  return length_ > (1 + kRounding) * options_.unchecked ? options_.max_push
                                                        : kInfinity;
}

bool StepLength::ShortenFor(double push) {
  if (push <= max_push()) return false;
  const double share =
      std::clamp(kAim * options_.max_push / push, 1.0 / 8, 1.0 / 2);
  length_ = std::max(options_.unchecked, share * length_);
  was_shortened_ = true;
  return true;
}

bool StepLength::Halve() {
  if (length_ <= (1 + kRounding) * options_.shortest) return false;
  length_ = std::max(options_.shortest, length_ / 2);
  was_shortened_ = true;
  return true;
}

void StepLength::Grow(double push) {
  if (was_shortened_) {
    was_shortened_ = false;
    return;
  }
  const double share =
      push > 0 ? std::clamp(kAim * options_.max_push / push, 1.0, 2.0) : 2;
  length_ = std::min(options_.longest, share * length_);
}

}  // namespace musclewarp
