// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/motion/recorded_step.h"

namespace musclewarp {

// How the end of a step that was taken again differs from the recorded one.
struct StepDifference {
  bool is_same = true;            // to the last bit
  bool is_other_outcome = false;  // given up by one of the two

  // Of all vertices, mm: where they are, and where the coarse meshes have them.
  double points = 0;
  double targets = 0;
};

// Returns the difference between the states in which a step ended.
StepDifference Compare(const ContactState& recorded, const ContactState& now);

// The stages of one step with so many threads. The last one is all that is in
// none of the others.
struct StepTimes {
  int threads = 0;
  std::vector<StageTime> stages;

  // Of all stages together.
  double Milliseconds() const;
  double ProcessorMilliseconds() const;
};

// Takes recorded steps of one scene again.
class StepReplay {
 public:
  // Prepares the scene. Throws InputError as Deformer does.
  StepReplay(const Scene& scene, const DeformerOptions& options);

  // Takes a step `repeats` times with so many threads. Returns the times of the
  // repetition of the median processor time. `difference` becomes that of the
  // last one. Throws InputError, naming `path`, if the step is of other meshes.
  StepTimes Take(const std::string& path,
                 const RecordedStep& step,
                 int threads,
                 int repeats,
                 StepDifference* difference) const;

 private:
  const DeformerOptions options_;
  const MuscleSolvers solvers_;
  Deformer deformer_;
  CertifiedScene at_rest_;  // before anything is attached
  CertifiedScene moving_;
};

}  // namespace musclewarp
