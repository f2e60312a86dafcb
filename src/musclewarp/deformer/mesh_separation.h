// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

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

  double gap = 0;  // that is kept, mm
};

// Returns options for a separation without a subsequent motion: without lines
// and attachments, and with displacements limited to the surroundings of
// overlaps.
RestSeparationOptions MeshSeparationOptions();

// Separates the meshes of a scene in their rest pose (SeparateRest), in which
// lines move nothing. Lengths among the options follow the size of the body but
// for `lengths_in_mm` (DeformerOptions); the result is in mm, apart from the
// state. `on_progress` may be empty. Throws InputError if the
// scene contradicts itself, a mesh cannot be read or repaired, or the meshes
// cannot be separated. Precondition (CHECKed): the options are valid.
MeshSeparation SeparateMeshes(const Scene& scene,
                              const RestSeparationOptions& options,
                              const ProgressCallback& on_progress,
                              const std::set<std::string>& lengths_in_mm = {});

}  // namespace musclewarp
