// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/interruption.h"

#include <stdexcept>
#include <string>

namespace musclewarp {
namespace {

constexpr std::array<int, 2> kSignals = {SIGINT, SIGTERM};

volatile std::sig_atomic_t noted_signal = 0;

}  // namespace

InterruptionScope::InterruptionScope() {
  noted_signal = 0;
  struct sigaction note = {};
  note.sa_handler = [](int signal) { noted_signal = signal; };
  note.sa_flags = SA_RESETHAND | SA_RESTART;
  for (size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &note, &before_[i]);
  }
}

InterruptionScope::~InterruptionScope() {
  for (size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
}

void ThrowIfInterrupted() {
  if (noted_signal == 0) return;
  throw std::runtime_error(
      std::string("interrupted by ") +
      (noted_signal == SIGINT ? "SIGINT (Ctrl-C)" : "SIGTERM"));
}

}  // namespace musclewarp
