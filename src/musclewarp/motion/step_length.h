// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace musclewarp {

// Bounds on the lengths of the steps to a pose. Lengths are fractions of the
// motion.
struct StepLengthOptions {
  double longest = 1;

  // A step in which contact pushes muscles by more than `max_push` (mm) from
  // their predicted positions is retried with a shorter length, but not with
  // less than `unchecked`.
  double max_push = 2;
  double unchecked = 1;

  // The lower bound of halved steps.
  double shortest = 1;
};

// Adapts the step length to the outcome of the step before, like the step size
// control of ODE solvers, with the push of contact as the error estimate.
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
  // Starts with the longest step.
  explicit StepLength(const StepLengthOptions& options);

  double length() const { return length_; }

  // Returns the end of the next step, which starts at `at`, and shortens the
  // step so that the remaining motion is a whole number of steps.
  double NextFrom(double at);

  // The largest admissible push in the next step, mm: infinite if its length is
  // at most `unchecked`.
  double max_push() const;

  // If `push` (mm) of the last step exceeds max_push(), shortens the next step
  // as if the push were proportional to the length. Returns false otherwise.
  bool ShortenFor(double push);

  // Halves the next step, down to the shortest length. Returns false at that
  // length.
  bool Halve();

  // Lengthens the next step as far as the push (mm) allows, at most by a factor
  // of two. Has no effect after a shortened step, as the next one would be
  // shortened again.
  void Grow(double push);

 private:
  StepLengthOptions options_;
  double length_;
  bool was_shortened_ = false;
};

}  // namespace musclewarp
