// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/scaled_frame.h"

#include "musclewarp/figures/scaled_figures.h"
#include "musclewarp/scene/scaled_scene.h"

namespace musclewarp {
namespace {

void ScaleLengths(double factor, MuscleFrame* muscle) {
  ScaleFigures<MuscleFigures>(factor, muscle);
  // What no solver has run has impossible values.
  if (muscle->solver.stop_reason == StopReason::kNotRun) muscle->solver = {};
  for (SolverIteration& iteration : muscle->solver.history) {
    iteration.max_step *= factor;
  }
  muscle->points *= factor;
  muscle->gaps *= factor;
  for (Points& line : muscle->lines) line *= factor;
  for (Points& fibre : muscle->fibres) fibre *= factor;
  for (Points& tendon : muscle->bare_tendons) tendon *= factor;
}

}  // namespace

void ScaleLengths(double factor, Frame* frame) {
  ScaleFigures<FiguresOfFrame<MuscleFrame>>(factor, frame);
  for (MuscleFrame& muscle : frame->muscles) ScaleLengths(factor, &muscle);
  for (Points& bone : frame->bones) bone *= factor;
  for (Eigen::Matrix4d& motion : frame->bones_from_rest) {
    ScaleTranslation(factor, &motion);
  }
}

}  // namespace musclewarp
