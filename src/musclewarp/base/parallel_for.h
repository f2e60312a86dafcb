// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace musclewarp {

// Calls body(i) for 0 <= i < count, on several threads. For few large items,
// such as meshes, which may throw: nothing may be thrown out of a parallel loop
// of OpenMP. What the call for the lowest i has thrown is thrown on. Items
// after one that threw may be left out, but none before it, so that what is
// thrown does not depend on the number of threads. Parallel loops within
// body(i) run on one thread, unless there is only one item.
//
// on_item(i, done), if given, is called by the calling thread before each of
// its items, with the number of items that are done; it may throw to stop.
template <typename Body>
void ParallelFor(
    size_t count,
    const Body& body,
    const std::function<void(size_t i, size_t done)>& on_item = {}) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::exception_ptr> thrown(count);
  std::atomic<size_t> first_thrown(count);
  std::atomic<size_t> done(0);
#pragma omp parallel for schedule(dynamic, 1) if (count > 1)
  for (size_t i = 0; i < count; ++i) {
    if (i > first_thrown) continue;
    try {
      if (on_item && std::this_thread::get_id() == caller) on_item(i, done);
      body(i);
      ++done;
    } catch (...) {
      thrown[i] = std::current_exception();
      size_t first = first_thrown;
      while (i < first && !first_thrown.compare_exchange_weak(first, i)) {
      }
    }
  }
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

}  // namespace musclewarp
