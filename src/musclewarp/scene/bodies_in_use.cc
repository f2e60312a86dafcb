// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

std::vector<std::string> BodiesInUse(const Scene& scene) {
  std::vector<std::string> bodies;
  const auto add = [&](const std::string& body) {
    if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) {
      bodies.push_back(body);
    }
  };
  for (const SceneBone& bone : scene.bones) add(bone.body);
  for (const SceneMuscle& muscle : scene.muscles) {
    for (const ActionLine& line : muscle.lines) {
      for (const std::string& body : line.bodies) add(body);
    }
    for (const Attachment& attachment : muscle.attachments) {
      add(attachment.body);
    }
  }
  return bodies;
}

}  // namespace musclewarp
