// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/interruption.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/program/program.h"

namespace musclewarp {
namespace {

constexpr std::array<int, 2> kSignals = {SIGINT, SIGTERM};

// The time from the signal until the program gives up its computation. Users
// expect it to have ended after two seconds.
constexpr std::chrono::milliseconds kPatience(1500);

volatile std::sig_atomic_t noted_signal = 0;

// The pipe to which the handler writes; writing is one of the few things that a
// signal handler may do.
std::array<int, 2> wake_pipe = {-1, -1};

void NoteSignal(int signal) {
  if (noted_signal != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  noted_signal = signal;
  const char byte = 1;
  // A failure does not matter: if the pipe is full, the watcher is awake.
  [[maybe_unused]] const ssize_t written = write(wake_pipe[1], &byte, 1);
}

std::string Reason() {
  return std::string("interrupted by ") +
         (noted_signal == SIGINT ? "SIGINT (Ctrl-C)" : "SIGTERM");
}

}  // namespace

InterruptionScope::InterruptionScope(
    std::function<void(const std::string& reason)> give_up)
    : give_up_(std::move(give_up)) {
  noted_signal = 0;
  if (pipe(wake_pipe.data()) != 0) {
    throw InputError(
        "a pipe for signals",
        std::string("cannot be made (") + std::strerror(errno) + ")",
        "close other programs, or raise the limit of open files "
        "(ulimit -n)");
  }
  watcher_ = std::thread([this] { Watch(); });
  struct sigaction note = {};
  note.sa_handler = NoteSignal;
  note.sa_flags = SA_RESTART;
  for (size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &note, &before_[i]);
  }
}

InterruptionScope::~InterruptionScope() {
  for (size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  close(wake_pipe[1]);  // wakes the watcher
  watcher_.join();
  close(wake_pipe[0]);
}

void InterruptionScope::Watch() {
  char byte;
  ssize_t count;
  do {
    count = read(wake_pipe[0], &byte, 1);
  } while (count < 0);
  if (count == 0) return;  // the scope is over
  std::fprintf(stderr,
               "\n%s: stopping after the last finished frame, in two seconds "
               "at most; once more to stop at once\n",
               Reason().c_str());
  std::unique_lock<std::mutex> lock(mutex_);
  if (changed_.wait_for(lock, kPatience, [this] { return is_over_; })) return;
  give_up_(Reason());
  _exit(kExitNotUsable);
}

void ThrowIfInterrupted() {
  if (noted_signal != 0) throw Interrupted(Reason());
}

}  // namespace musclewarp
