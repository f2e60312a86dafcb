// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// Says how far a run is: on a terminal one line that renews itself, elsewhere a
// line a frame.
class Progress {
 public:
  // `done` of `total` frames are there already.
  Progress(int done, int total, bool is_terminal, std::ostream* out);

  void FrameDone(const FrameRecord& frame);

 private:
  int first_;
  int done_;
  int total_;
  bool is_terminal_;
  std::ostream* out_;
  Stopwatch stopwatch_;
};

// "50 s", "12 min", "3 h": what people want to know of a time, ms.
std::string RoundedTime(double milliseconds);

}  // namespace musclewarp
