// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/base/progress.h"
#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Meshes that have been separated, and their certificate.
struct MeshSeparation {
  PreparedScene scene;
  RestResult rest;

  // What crossed before anything was separated or made anew.
  SceneIntersections before;

  // The separated meshes, measured and judged.
  Frame frame;
};

// Options with which meshes are separated that no motion follows: neither lines
// nor attachments are made, and only what is around an overlap moves.
RestSeparationOptions MeshSeparationOptions();

// Separates the meshes of a scene as they are (SeparateRest). Poses and lines
// are of no use to it. `on_progress` may be empty. Throws InputError if the
// scene contradicts itself, a mesh cannot be read or repaired, or the meshes
// cannot be separated. Precondition (CHECKed): the options are valid.
MeshSeparation SeparateMeshes(const Scene& scene,
                              const RestSeparationOptions& options,
                              const ProgressCallback& on_progress);

}  // namespace musclewarp
