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

// Thrown if a signal stops the program.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// As long as an object of this class exists, SIGINT (Ctrl-C) and SIGTERM do not
// end the program. The program says at once that it is stopping, and from then
// on ThrowIfInterrupted() throws, so that the program can stop where nothing is
// lost. If it has not stopped in time, because it is inside a long computation,
// another thread calls `give_up` to save the results so far and ends the
// program with exit code 1. A second signal ends the program at once.
class InterruptionScope {
 public:
  // `give_up` receives the reason. It must not wait for the thread that
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

// Throws Interrupted, which names the signal, if a signal has arrived.
void ThrowIfInterrupted();

}  // namespace musclewarp
