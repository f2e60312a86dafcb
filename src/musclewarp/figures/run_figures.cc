// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/run_figures.h"

namespace musclewarp {

RunFigures FiguresOf(const std::vector<FrameFigures>& frames,
                     int frames_planned,
                     bool finished,
                     const std::string& stopped) {
  RunFigures run;
  run.frames = static_cast<int>(frames.size());
  run.usable = !frames.empty();
  for (const FrameFigures& frame : frames) {
    run.frames_clean += frame.IsClean();
    run.usable = run.usable && frame.IsUsable();
    run.worst_volume_error =
        Larger(run.worst_volume_error, frame.WorstVolumeError());
    run.worst_folded_triangles =
        Larger(run.worst_folded_triangles,
               LargestOf(frame.muscles, &MuscleFigures::folded_triangles));
  }
  run.wall_ms_per_frame_median = MedianOf(frames, &FrameFigures::wall_ms);
  run.frames_planned = frames_planned;
  run.finished = finished;
  run.stopped = stopped;
  return run;
}

}  // namespace musclewarp
