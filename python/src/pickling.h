// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <string>

#include "python/src/frames.h"
#include "python/src/run_of_deformer.h"
#include "python/src/scene.h"

namespace musclewarp::python {

// Returns a hash of all on which the frames of a deformer depend but their
// poses: the meshes and lines at rest, the attachments, and the keywords but
// `cache`.
std::string KeyOf(const PreparedScene& scene,
                  const std::map<std::string, std::string>& keywords);

// The states of objects by which Python pickles and copies them. They are for
// processes of the same version of the package.
template <typename T>
pybind11::bytes StateForPickle(const T& object);

// Throws InputError for a state of another version.
template <typename T>
std::shared_ptr<T> FromStateForPickle(const pybind11::bytes& state);

// Makes a class support pickle and copy: `type.def(Pickled<T>())`.
template <typename T>
auto Pickled() {
  return pybind11::pickle(&StateForPickle<T>, &FromStateForPickle<T>);
}

// The same for a muscle or a bone of a frame, which brings the frame along.
template <typename Part>
auto PickledPartOfFrame() {
  return pybind11::pickle(
      [](const Part& part) { return pybind11::make_tuple(part.of, part.idx); },
      [](const pybind11::tuple& state) {
        return Part{state[0].cast<SharedFrame>(), state[1].cast<size_t>()};
      });
}

extern template pybind11::bytes StateForPickle(const TriangleSoup&);
extern template pybind11::bytes StateForPickle(const ActionLine&);
extern template pybind11::bytes StateForPickle(const Attachment&);
extern template pybind11::bytes StateForPickle(const SceneMuscle&);
extern template pybind11::bytes StateForPickle(const SceneBone&);
extern template pybind11::bytes StateForPickle(const ScenePose&);
extern template pybind11::bytes StateForPickle(const Scene&);
extern template pybind11::bytes StateForPickle(const FrameOfScene&);
extern template pybind11::bytes StateForPickle(const RunOfDeformer&);

}  // namespace musclewarp::python
