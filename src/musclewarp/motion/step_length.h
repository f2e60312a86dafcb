// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace musclewarp {

// How long the steps may be in which a pose is reached. Lengths are shares of
// the way.
struct StepLengthOptions {
  double longest = 1;

  // A step in which contact pushes muscles by more than this beside the way
  // that they are carried, mm, is tried again with a shorter length, but none
  // that is as short as `unchecked`.
  double max_push = 2;
  double unchecked = 1;

  // No step is halved to less than this.
  double shortest = 1;
};

// Chooses the length of each step by what came of the one before, as solvers of
// differential equations do, with the push of contact as the error.
//
//   StepLength length(options);
//   double at = 0;
//   while (at < 1) {
//     const double to = length.NextFrom(at);
//     const Result result = Try(to);
//     if (length.ShortenFor(result.push)) continue;
//     if (result.crosses && length.Halve()) continue;
//     length.Grow(result.push);
//     at = to;
//   }
class StepLength {
 public:
  // Begins with the longest step.
  explicit StepLength(const StepLengthOptions& options);

  double length() const { return length_; }

  // Returns where the next step, from `at`, ends. It is as much shorter than it
  // might be as makes the rest of the way a whole number of steps.
  double NextFrom(double at);

  // The push that is allowed in the next step, mm: any if it is short.
  double max_push() const;

  // If the last step pushed by more than that, makes the next one shorter, by
  // as much as it takes if the push is proportional to the length. Returns
  // false if it did not.
  bool ShortenFor(double push);

  // Halves the next step, down to the shortest. Returns false if it is as short
  // as that.
  bool Halve();

  // Lets the next step be longer, up to twice, as the push (mm) allows. Not if
  // the last one had to be shortened: it would be again.
  void Grow(double push);

 private:
  StepLengthOptions options_;
  double length_;
  bool was_shortened_ = false;
};

}  // namespace musclewarp
