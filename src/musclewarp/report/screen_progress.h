// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/figures/frame_figures.h"

namespace musclewarp {

// Says on the screen how far a run has come. On a terminal that is one line
// which renews itself; elsewhere a line for each frame, and one every ten
// seconds while nothing else is printed, also while a long computation says
// nothing.
//
//   ScreenProgress progress(is_terminal, &std::cout);
//   deformer_options.on_progress = [&](const Progress& p) { progress.Say(p); };
//   ...
//   progress.StartFrames(0, {1, 4, 2});
//   for (...) progress.FrameDone(record);
class ScreenProgress {
 public:
  ScreenProgress(bool is_terminal, std::ostream* out);
  ~ScreenProgress();

  // To be called from within a long computation.
  void Say(const Progress& progress);

  // Ends what Say() began, and clears the line of a terminal, for other output.
  void Clear();

  // Begins to count frames, of which `done` are there already. `work` is what
  // each of the others is expected to take, in any unit: the time that is left
  // is foretold by it.
  void StartFrames(int done, std::vector<double> work);

  void FrameDone(const FrameFigures& frame);

  // Returns the time that is left, ms, from what the last frames took for their
  // work. A frame counts 0.8 times as much as the one after it, as frames
  // differ and the next ones are like the last.
  double MillisecondsLeft() const;

 private:
  int total() const { return done_before_ + static_cast<int>(work_.size()); }
  std::string Bar() const;
  void Print(const std::string& line, bool is_last);

  // On a thread of its own: repeats what was said last, with the time since the
  // frame began, whenever nothing was printed for a while.
  void SayThatItGoesOn();

  bool is_terminal_;
  std::ostream* out_;
  mutable std::mutex mutex_;  // of everything below
  std::condition_variable ended_;
  bool is_over_ = false;
  std::string stage_;  // said last; empty after Clear()
  size_t length_ = 0;  // of the line on the terminal
  Stopwatch since_output_;
  Stopwatch since_frame_;

  int done_before_ = 0;
  size_t done_ = 0;  // of work_
  std::vector<double> work_;
  double recent_ms_ = 0, recent_work_ = 0;
  std::thread heartbeat_;
};

// "50 s", "12 min", "3 h": a time (ms) as precise as people want to know it.
std::string RoundedTime(double milliseconds);

}  // namespace musclewarp
