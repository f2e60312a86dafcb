// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/phantom_scene.h"

#include "musclewarp/base/input_error.h"
#include "musclewarp/phantom/hip_scene.h"

namespace musclewarp {

std::vector<std::string> PhantomSceneNames() { return {"hip"}; }

PhantomScene MakePhantomScene(const std::string& name, uint32_t seed) {
  if (name == "hip") return MakeHipScene(seed);
  std::string known;
  for (const std::string& other : PhantomSceneNames()) {
    known += (known.empty() ? "" : ", ") + other;
  }
  throw InputError("--scene",
                   "there is no scene \"" + name + "\"",
                   "choose one of: " + known);
}

}  // namespace musclewarp
