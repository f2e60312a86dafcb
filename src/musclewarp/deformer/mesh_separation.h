// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/base/progress.h"
#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The result of SeparateMeshes: the separated meshes and their certificate.
struct MeshSeparation {
  PreparedScene scene;
  RestResult rest;

  // The intersections before separation and reconstruction.
  SceneIntersections before;

  // The separated meshes, measured and judged.
  Frame frame;
};

// Returns options for a separation without a subsequent motion: without lines
// and attachments, and with displacements limited to the surroundings of
// overlaps.
RestSeparationOptions MeshSeparationOptions();

// Separates the meshes of a scene in their rest pose (SeparateRest), in which
// lines move nothing. `on_progress` may be empty. Throws InputError if the
// scene contradicts itself, a mesh cannot be read or repaired, or the meshes
// cannot be separated. Precondition (CHECKed): the options are valid.
MeshSeparation SeparateMeshes(const Scene& scene,
                              const RestSeparationOptions& options,
                              const ProgressCallback& on_progress);

}  // namespace musclewarp
