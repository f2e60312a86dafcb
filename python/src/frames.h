// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp::python {

// A muscle or a bone, in all frames.
struct ScenePart {
  std::string name;
  Triangles triangles;
  std::vector<std::string> lines;  // the names of those of a muscle
};

// What all frames of a deformer have in common. Frames keep it, so that they
// outlive their deformer.
struct SceneParts {
  std::vector<ScenePart> muscles;
  std::vector<ScenePart> bones;

  // KeyOf() (pickling.h): deformers of one key compute the same frames, in
  // other processes too.
  std::string key;
};

// `keywords` are those of the deformer.
std::shared_ptr<const SceneParts> PartsOf(
    const PreparedScene& scene,
    const std::map<std::string, std::string>& keywords = {});

// A frame, with all that is needed to show it.
struct FrameOfScene {
  Frame frame;
  std::shared_ptr<const SceneParts> parts;
};
using SharedFrame = std::shared_ptr<FrameOfScene>;

// A muscle of a frame, and a bone.
struct MuscleOfFrame {
  SharedFrame of;
  size_t idx;

  const MuscleFrame& muscle() const { return of->frame.muscles[idx]; }
  const ScenePart& part() const { return of->parts->muscles[idx]; }
};

struct BoneOfFrame {
  SharedFrame of;
  size_t idx;

  const Points& points() const { return of->frame.bones[idx]; }
  const ScenePart& part() const { return of->parts->bones[idx]; }
};

}  // namespace musclewarp::python
