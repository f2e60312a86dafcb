// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/phantom_scene.h"

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/phantom/hip_scene.h"
#include "musclewarp/phantom/random_scene.h"
#include "musclewarp/phantom/stress_scenes.h"

namespace musclewarp {
namespace {

constexpr char kRandom[] = "random";

}  // namespace

std::vector<std::string> PhantomSceneNames() {
  std::vector<std::string> names = StressSceneNames();
  names.insert(names.begin(), "hip");
  names.push_back(kRandom);
  return names;
}

PhantomScene MakePhantomScene(const std::string& name,
                              uint32_t seed,
                              int num_muscles) {
  if (name == kRandom) return MakeRandomScene(seed, num_muscles);
  if (num_muscles != 0) {
    throw InputError("{num_muscles}",
                     "is " + std::to_string(num_muscles) +
                         ", but the scene \"" + name + "\" is not drawn",
                     "leave {num_muscles} out, or choose {scene}=random");
  }
  if (name == "hip") return MakeHipScene(seed);
  const std::vector<std::string> stress = StressSceneNames();
  if (std::find(stress.begin(), stress.end(), name) != stress.end()) {
    return MakeStressScene(name, seed);
  }
  const std::vector<std::string> known = PhantomSceneNames();
  throw InputError("{scene}",
                   "there is no scene \"" + name + "\"",
                   DidYouMean(name, known) +
                       "choose one of: " + ShortList(known, known.size()));
}

}  // namespace musclewarp
