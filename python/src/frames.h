// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp::python {

// What all frames of a deformer have in common. Frames keep it, so that they
// outlive their deformer.
struct SceneParts {
  struct Part {
    std::string name;
    Triangles triangles;
    std::vector<std::string> lines;  // the names of those of a muscle
  };
  std::vector<Part> muscles;
  std::vector<Part> bones;
};

std::shared_ptr<const SceneParts> PartsOf(const PreparedScene& scene);

// A frame, with all that is needed to show it.
struct FrameOfScene {
  Frame frame;
  std::shared_ptr<const SceneParts> parts;
};

}  // namespace musclewarp::python
