// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/stage_times.h"

#include <algorithm>
#include <ctime>

namespace musclewarp {
namespace {

thread_local StageRecording* recording_of_thread = nullptr;

// The time that all threads of the process have computed so far.
double ProcessorMilliseconds() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

StageRecording::StageRecording() : outer_(recording_of_thread) {
  recording_of_thread = this;
}

StageRecording::~StageRecording() { recording_of_thread = outer_; }

StageTime& StageRecording::Of(const char* name) {
  auto stage = std::find_if(times_.begin(), times_.end(), [&](const auto& t) {
    return t.name == name;
  });
  if (stage == times_.end()) {
    stage = times_.insert(stage, StageTime());
    stage->name = name;
  }
  return *stage;
}

ScopedStage::ScopedStage(const char* name)
    : recording_(recording_of_thread),
      outer_(recording_ ? recording_->innermost_ : nullptr),
      name_(name) {
  if (!recording_) return;
  if (outer_) outer_->AddToRecording();
  recording_->innermost_ = this;
  ++recording_->Of(name_).visits;
  Restart();
}

ScopedStage::~ScopedStage() {
  if (!recording_) return;
  AddToRecording();
  recording_->innermost_ = outer_;
  if (outer_) outer_->Restart();
}

void ScopedStage::AddToRecording() const {
  StageTime& stage = recording_->Of(name_);
  stage.ms += watch_.Milliseconds();
  stage.processor_ms += ProcessorMilliseconds() - processor_ms_before_;
  const WorkCounts work = WorkSoFar();
  for (size_t i = 0; i < work.size(); ++i) {
    stage.work[i] += work[i] - work_before_[i];
  }
}

void ScopedStage::Restart() {
  watch_.Restart();
  processor_ms_before_ = ProcessorMilliseconds();
  work_before_ = WorkSoFar();
}

}  // namespace musclewarp
