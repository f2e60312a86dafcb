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

// Prints the progress of a run: what is being done, how far it is, and the time
// since the run or the frame began. On a terminal this is a single line that is
// renewed every second and cut to the width of the terminal; elsewhere it is a
// line at the beginning, one for each frame, and one a minute if nothing else
// is printed, even if a long computation reports nothing.
//
//   ScreenProgress progress(is_terminal, &std::cout);
//   deformer_options.on_progress = [&](const Progress& p) { progress.Say(p); };
//   ...
//   progress.StartFrames(0, {1, 4, 2});
//   for (...) progress.FrameDone(record, name);
class ScreenProgress {
 public:
  ScreenProgress(bool is_terminal, std::ostream* out);
  ~ScreenProgress();

  // Takes a progress report. Long computations call this.
  void Say(const Progress& progress);

  // Ends the progress report, and clears the line of a terminal, for other
  // output.
  void Clear();

  // Starts to count frames after the `done` frames that exist already. `work`
  // is the expected effort for each remaining frame, in any unit; the estimate
  // of the remaining time is based on it.
  void StartFrames(int done, std::vector<double> work);

  // `name` is what the frame is called (run/pose_name.h).
  void FrameDone(const FrameFigures& frame, const std::string& name);

  // Returns the estimated remaining time, ms, from the time per work of recent
  // frames. Each frame has 0.8 times the weight of the next one, because frames
  // differ and the next frames resemble the latest.
  double MillisecondsLeft() const;

 private:
  int total() const { return done_before_ + static_cast<int>(work_.size()); }
  std::string Bar() const;
  void Print(const std::string& text, bool is_last);

  // Prints the last progress report, unless the last output is recent.
  void PrintStage();

  // Runs on a separate thread, and calls PrintStage().
  void SayThatItGoesOn();

  bool is_terminal_;
  std::ostream* out_;
  mutable std::mutex mutex_;  // of everything below
  std::condition_variable ended_;
  bool is_over_ = false;
  std::string stage_;  // the last progress report; empty after Clear()
  size_t length_ = 0;  // of the line on the terminal
  bool has_output_ = false;
  Stopwatch since_output_;
  Stopwatch since_frame_;

  int done_before_ = 0;
  size_t done_ = 0;  // of work_
  std::vector<double> work_;
  double recent_ms_ = 0, recent_work_ = 0;
  std::thread heartbeat_;
};

// Returns a time (ms) rounded for readers: "50 s", "12 min", "3 h".
std::string RoundedTime(double milliseconds);

}  // namespace musclewarp
