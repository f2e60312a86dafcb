// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

namespace musclewarp {

// The number of threads of the parallel loops that follow: 1 in a build without
// OpenMP. It decides on how long they take, not on what comes out.
inline int NumThreads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

// Sets it. Precondition: `count` is above 0.
inline void SetNumThreads([[maybe_unused]] int count) {
#ifdef _OPENMP
  omp_set_num_threads(count);
#endif
}

}  // namespace musclewarp
