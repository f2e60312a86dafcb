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

constexpr char kHip[] = "hip";
constexpr char kRandom[] = "random";

PhantomScene SceneNamed(const std::string& name,
                        uint32_t seed,
                        const Variation& variation) {
  if (name == kRandom) {
    return MakeRandomScene(seed, variation.num_muscles, variation.num_poses);
  }
  if (name == kHip) return MakeHipScene(seed);
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

void RefuseNumber(const std::string& setting,
                  int value,
                  const std::string& scene) {
  if (value == 0 || scene == kRandom) return;
  throw InputError("{" + setting + "}",
                   "is " + std::to_string(value) + ", but the scene \"" +
                       scene + "\" is not drawn",
                   "leave {" + setting + "} out, or choose {scene}=random");
}

}  // namespace

std::vector<std::string> PhantomSceneNames() {
  std::vector<std::string> names = StressSceneNames();
  names.insert(names.begin(), kHip);
  names.push_back(kRandom);
  return names;
}

PhantomScene MakePhantomScene(const std::string& name,
                              uint32_t seed,
                              const Variation& variation) {
  RefuseNumber("num_muscles", variation.num_muscles, name);
  RefuseNumber("num_vertices", variation.num_vertices, name);
  RefuseNumber("num_poses", variation.num_poses, name);
  PhantomScene made = SceneNamed(name, seed, variation);
  const bool is_placed = variation.size != 1 || variation.offset != 0;
  if (is_placed && !made.model_text.empty()) {
    throw InputError("{scene}",
                     "\"" + name +
                         "\" has a model of OpenSim, which keeps its "
                         "size and place",
                     "leave {size} and {offset} out, or choose another scene");
  }
  if (variation.num_vertices > 0) GiveVertices(variation.num_vertices, &made);
  Place(variation.size, variation.offset, &made);
  return made;
}

}  // namespace musclewarp
