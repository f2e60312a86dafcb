// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/figures/frame_figures.h"

namespace musclewarp {

// What the frames of a run come to: "summary" in report.json.
struct RunFigures {
  int frames = 0;
  int frames_clean = 0;
  double worst_volume_error = 0;
  int worst_folded_triangles = 0;
  double wall_ms_per_frame_median = 0;
  int frames_planned = 0;
  bool finished = false;  // true if all frames are there
  std::string stopped;    // why the run ended before that, or empty
  bool usable = false;
};

constexpr auto FieldsOf(Described<RunFigures>) {
  using F = RunFigures;
  return std::make_tuple(
      Field(&F::frames, "frames").Text("frames that are there").AtLeast(0),
      Field(&F::frames_clean, "frames_clean")
          .Text("frames in which nothing crosses")
          .AtLeast(0),
      Field(&F::worst_volume_error, "worst_volume_error")
          .Text("the largest size of a `volume_error` of a muscle in a frame")
          .AtLeast(0),
      Field(&F::worst_folded_triangles, "worst_folded_triangles")
          .Text("the largest `folded_triangles` of a muscle in a frame")
          .AtLeast(0),
      Field(&F::wall_ms_per_frame_median, "wall_ms_per_frame_median", "ms")
          .Text("the median of `frames[].wall_ms`")
          .AtLeast(0),
      Field(&F::frames_planned, "frames_planned")
          .Text("frames of the whole run")
          .AtLeast(0),
      Field(&F::finished, "finished").Text("true if all frames are there"),
      Field(&F::stopped, "stopped")
          .Text("why not, if the program could tell, else null")
          .NullIfEmpty(),
      Field(&F::usable, "usable")
          .Text("true if there are frames and all of them are usable"));
}

// Sums up the frames of a run of `frames_planned`, which ended before the last
// one because of `stopped`, if that is not empty.
RunFigures FiguresOf(const std::vector<FrameFigures>& frames,
                     int frames_planned,
                     bool finished,
                     const std::string& stopped);

}  // namespace musclewarp
