// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace musclewarp::python {

// A call from Python whose computation runs with the interpreter free, on a
// thread of its own. The calling thread waits for it and looks for signals
// meanwhile, so that Ctrl-C raises KeyboardInterrupt at once, whatever the
// library is in the middle of. The computation is then abandoned: it ends when
// it next calls ThrowIfAbandoned(), which on_progress does.
struct RunningCall {
  std::atomic<bool> is_abandoned{false};

  // The call whose progress callback made this one, or null.
  const RunningCall* parent = nullptr;
};

// Thrown in a computation that was abandoned, and caught where it began.
struct Abandoned {};

// The call that this thread computes, or null.
const RunningCall* CurrentCall();

// For long computations, from time to time. Does nothing outside of a call.
void ThrowIfAbandoned();

// Runs `work` as described above. What it throws is thrown on. It must own all
// that it uses, but no Python object, as it may outlive the call. Precondition:
// the interpreter is held.
void RunFree(std::function<void()> work);

// The same for work that returns something.
template <typename Work>
auto ComputeFree(Work work) {
  using Result = decltype(work());
  auto result = std::make_shared<std::optional<Result>>();
  RunFree([work = std::move(work), result] { result->emplace(work()); });
  return std::move(**result);
}

// The number of threads of a computation; 0: as OpenMP chooses.
void SetThreads(int threads);
int Threads();

// Waits until no abandoned computation is left, at most so long, s. False if
// there is still one. Precondition: the interpreter is held.
bool WaitForAbandoned(double seconds);

// What only one call at a time may use. Those of other threads wait.
class OneAtATime {
 public:
  // Throws std::runtime_error if the call that holds it, from a progress
  // callback, wants it again, which would wait for ever. To be called before
  // the computation begins.
  void RefuseNested(const char* what) const;

  // Waits; to be called by the computation.
  void Enter();
  void Leave();

 private:
  std::atomic<const RunningCall*> holder_{nullptr};
};

// Holds it for the length of a scope.
class Turn {
 public:
  explicit Turn(OneAtATime* one) : one_(one) { one_->Enter(); }
  ~Turn() { one_->Leave(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  OneAtATime* one_;
};

}  // namespace musclewarp::python
