// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include "musclewarp/build_info/build_info.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/settings/thread_settings.h"
#include "python/src/bindings.h"
#include "python/src/call.h"

// The part of the Python package that is C++: python/musclewarp/__init__.py
// says what of it is for users.
PYBIND11_MODULE(_core, module) {
  using namespace musclewarp::python;  // NOLINT(google-build-using-namespace)
  BindErrors(&module);
  BindLog(&module);
  BindSettings(&module);
  BindMeshes(&module);
  BindOpenSim(&module);
  BindSceneParts(&module);
  BindScene(&module);
  BindFrames(&module);
  BindDeformer(&module);
  BindRun(&module);
  BindPaths(&module);
  BindChecks(&module);
  BindLabels(&module);
  BindJoints(&module);
  module.attr("__version__") = musclewarp::kVersion;
  module.attr("__sources_hash__") = musclewarp::kSourcesHash;
  module.def(
      "set_threads",
      [](int threads) {
        musclewarp::CheckSettings(musclewarp::ThreadSettings{threads});
        SetThreads(threads);
      },
      pybind11::arg("threads"),
      "Sets how many threads computations use; 0: as OpenMP chooses, one a "
      "core. Results do not depend on it.");
  module.def(
      "threads", &Threads, "Returns what set_threads() has set, at first 0.");
  module.def("wait_for_abandoned", &WaitForAbandoned, pybind11::arg("seconds"));
}
