// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/phantom_scene.h"

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/phantom/hip_scene.h"
#include "musclewarp/phantom/stress_scenes.h"

namespace musclewarp {

std::vector<std::string> PhantomSceneNames() {
  std::vector<std::string> names = StressSceneNames();
  names.insert(names.begin(), "hip");
  return names;
}

PhantomScene MakePhantomScene(const std::string& name, uint32_t seed) {
  if (name == "hip") return MakeHipScene(seed);
  const std::vector<std::string> stress = StressSceneNames();
  if (std::find(stress.begin(), stress.end(), name) != stress.end()) {
    return MakeStressScene(name, seed);
  }
  std::string known;
  for (const std::string& other : PhantomSceneNames()) {
    known += (known.empty() ? "" : ", ") + other;
  }
  throw InputError("--scene",
                   "there is no scene \"" + name + "\"",
                   "choose one of: " + known);
}

}  // namespace musclewarp
