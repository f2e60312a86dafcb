// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <condition_variable>
#include <csignal>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

namespace musclewarp {

// Thrown where a program stops because of a signal.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// While it lives, SIGINT (Ctrl-C) and SIGTERM do not end the program: it says
// at once that it is stopping, and ThrowIfInterrupted() throws from then on, so
// that the program can stop where nothing is lost. If it has not done so in
// time, as it is inside a long computation, `give_up` is called on another
// thread to save what there is, and the program ends with exit code 1. A second
// signal ends it at once.
class InterruptionScope {
 public:
  // `give_up` is told the reason. It must not wait for the thread that
  // computes.
  explicit InterruptionScope(
      std::function<void(const std::string& reason)> give_up);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

 private:
  // Waits for a signal and then for the end of the scope.
  void Watch();

  std::function<void(const std::string& reason)> give_up_;
  std::array<struct sigaction, 2> before_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_over_ = false;
  std::thread watcher_;
};

// Throws Interrupted, whose text names the signal, if one came.
void ThrowIfInterrupted();

}  // namespace musclewarp
