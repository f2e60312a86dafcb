// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/base/work_counts.h"

namespace musclewarp {

// What a stage of a computation took, all its visits together.
struct StageTime {
  std::string name;
  double ms = 0;  // wall time
  int visits = 0;

  // The time of all threads of the process, ms, and their work.
  double processor_ms = 0;
  WorkCounts work = {};
};

class ScopedStage;

// Records how long the stages of a computation take. While it exists, every
// ScopedStage of the same thread is added to it. One thread has one recording
// at a time; stages cost nothing that counts where there is none.
//
//   StageRecording recording;
//   frame = deformer.MoveTo(pose);
//   for (const StageTime& stage : recording.times()) Print(stage);
class StageRecording {
 public:
  StageRecording();
  ~StageRecording();
  StageRecording(const StageRecording&) = delete;
  StageRecording& operator=(const StageRecording&) = delete;

  // The stages in the order in which they were entered first.
  const std::vector<StageTime>& times() const { return times_; }

 private:
  friend class ScopedStage;
  StageTime& Of(const char* name);

  std::vector<StageTime> times_;
  ScopedStage* innermost_ = nullptr;
  StageRecording* const outer_;
};

// A stage, from the construction of this object to its end. The time of a stage
// that is entered within another one counts for the inner one alone, so that
// the times of all stages add up. To be used outside of parallel regions: it is
// the calling thread that takes part in a recording.
class ScopedStage {
 public:
  // `name`: a literal, which is kept as a pointer.
  explicit ScopedStage(const char* name);
  ~ScopedStage();
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;

 private:
  // Adds to the stage what there was since Restart().
  void AddToRecording() const;
  void Restart();

  StageRecording* const recording_;
  ScopedStage* const outer_;
  const char* const name_;
  Stopwatch watch_;
  double processor_ms_before_ = 0;
  WorkCounts work_before_ = {};
};

}  // namespace musclewarp
