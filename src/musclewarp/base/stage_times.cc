// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/stage_times.h"

#include <algorithm>

namespace musclewarp {
namespace {

thread_local StageRecording* recording_of_thread = nullptr;

}  // namespace

StageRecording::StageRecording() : outer_(recording_of_thread) {
  recording_of_thread = this;
}

StageRecording::~StageRecording() { recording_of_thread = outer_; }

void StageRecording::Add(const char* name, double ms, int visits) {
  auto stage = std::find_if(times_.begin(), times_.end(), [&](const auto& t) {
    return t.name == name;
  });
  if (stage == times_.end()) stage = times_.insert(stage, {name, 0, 0});
  stage->ms += ms;
  stage->visits += visits;
}

ScopedStage::ScopedStage(const char* name)
    : recording_(recording_of_thread),
      outer_(recording_ ? recording_->innermost_ : nullptr),
      name_(name) {
  if (!recording_) return;
  if (outer_) recording_->Add(outer_->name_, outer_->watch_.Milliseconds(), 0);
  recording_->innermost_ = this;
  recording_->Add(name_, 0, 1);
  watch_.Restart();
}

ScopedStage::~ScopedStage() {
  if (!recording_) return;
  recording_->Add(name_, watch_.Milliseconds(), 0);
  recording_->innermost_ = outer_;
  if (outer_) outer_->watch_.Restart();
}

}  // namespace musclewarp
