// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "python/src/frames.h"

namespace musclewarp::python {

// What a run writes of its deformer, without which it can go on.
struct RunBasis {
  std::string solver;
  std::map<std::string, std::string> keywords;  // as users gave them
  std::shared_ptr<const SceneParts> parts;
  std::shared_ptr<const PreparedScene> scene;  // unpickled: not for solvers
  ContactReport contact;
  Frame rest;
};

// Frames of one deformer in their order: what musclewarp-deform writes.
struct RunOfDeformer {
  std::shared_ptr<const RunBasis> basis;
  std::vector<SharedFrame> frames;
};

}  // namespace musclewarp::python
