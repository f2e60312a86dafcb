// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/deformer/pose_walk.h"
#include "python/src/call.h"
#include "python/src/frames.h"
#include "python/src/scene.h"

namespace musclewarp::python {

// A deformer that several threads may use, one after the other.
struct SharedDeformer {
  OneAtATime turns;
  std::string solver;
  std::map<std::string, std::string> keywords;  // as users gave them
  std::optional<Deformer> deformer;
  std::optional<PoseWalk> walk;  // of the deformer
  std::shared_ptr<const SceneParts> parts;

  // Runs `work` with the deformer, as ComputeFree() does, when it is its turn.
  template <typename Work>
  static auto Compute(const std::shared_ptr<SharedDeformer>& self, Work work) {
    self->turns.RefuseNested("the deformer");
    return ComputeFree([self, work = std::move(work)] {
      const Turn turn(&self->turns);
      return work(&*self->deformer);
    });
  }

  // The same for work that returns a frame.
  template <typename Work>
  static std::shared_ptr<FrameOfScene> ComputeFrame(
      const std::shared_ptr<SharedDeformer>& self, Work work) {
    return Compute(self, [self, work = std::move(work)](Deformer* deformer) {
      return std::make_shared<FrameOfScene>(
          FrameOfScene{work(deformer), self->parts});
    });
  }
};

// Returns a callback for a computation that may be abandoned, which it then
// stops. `progress` is None or a function of Python that is called with the
// stage, how many of its parts are done, and how many there are.
ProgressCallback CallbackOf(const pybind11::object& progress);

}  // namespace musclewarp::python
