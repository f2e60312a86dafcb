// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/call.h"

#include <omp.h>

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include "python/src/bindings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// How often the thread that waits looks for signals.
constexpr std::chrono::milliseconds kLook(50);

// How often a computation looks whether what it needs is free.
constexpr std::chrono::milliseconds kTry(2);

thread_local const RunningCall* current_call = nullptr;

std::atomic<int> threads_of_calls{0};

// Counts the computations that run.
std::mutex running_mutex;
std::condition_variable running_changed;
int running = 0;

void Compute(std::packaged_task<void()> task, const RunningCall* call) {
  current_call = call;
  if (threads_of_calls > 0) omp_set_num_threads(threads_of_calls);
  task();
  task = {};  // what it owns goes before it is counted as ended
  const std::lock_guard<std::mutex> lock(running_mutex);
  --running;
  running_changed.notify_all();
}

}  // namespace

const RunningCall* CurrentCall() { return current_call; }

void ThrowIfAbandoned() {
  if (current_call && current_call->is_abandoned) throw Abandoned();
}

void RunFree(std::function<void()> work) {
  auto call = std::make_shared<RunningCall>();
  call->parent = current_call;
  std::packaged_task<void()> task(std::move(work));
  std::future<void> done = task.get_future();
  {
    const std::lock_guard<std::mutex> lock(running_mutex);
    ++running;
  }
  std::thread([call, task = std::move(task)]() mutable {
    Compute(std::move(task), call.get());
  }).detach();
  for (bool is_done = false; !is_done;) {
    {
      const py::gil_scoped_release free;
      is_done = done.wait_for(kLook) == std::future_status::ready;
    }
    ForwardLog();
    if (!is_done && PyErr_CheckSignals() != 0) {
      call->is_abandoned = true;
      throw py::error_already_set();
    }
  }
  done.get();
}

void SetThreads(int threads) { threads_of_calls = threads; }

int Threads() { return threads_of_calls; }

bool WaitForAbandoned(double seconds) {
  const py::gil_scoped_release free;
  std::unique_lock<std::mutex> lock(running_mutex);
  return running_changed.wait_for(lock,
                                  std::chrono::duration<double>(seconds),
                                  [] { return running == 0; });
}

void OneAtATime::RefuseNested(const char* what) const {
  for (const RunningCall* call = current_call; call; call = call->parent) {
    if (call != holder_) continue;
    throw std::runtime_error(std::string(what) +
                             " is in use by the call that reports this "
                             "progress; use it again when that has returned");
  }
}

void OneAtATime::Enter() {
  const RunningCall* nobody = nullptr;
  while (!holder_.compare_exchange_strong(nobody, current_call)) {
    nobody = nullptr;
    ThrowIfAbandoned();
    std::this_thread::sleep_for(kTry);
  }
}

void OneAtATime::Leave() { holder_ = nullptr; }

}  // namespace musclewarp::python
