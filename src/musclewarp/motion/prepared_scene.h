// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/fibres/fibres.h"
#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/mesh_repair/sliver_removal.h"
#include "musclewarp/scene/exempt_area.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/solver/carried_lines.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

struct PrepareOptions {
  MuscleModelOptions muscle;
  RepairOptions repair;
  // Whether slivers are taken out of muscles. Certified contact needs that;
  // without, meshes keep their triangles.
  bool remove_slivers = false;
  SliverLimits slivers;

  // Lines made for a muscle that has none.
  int auto_lines = 3;

  // Fibres of every muscle; none by default.
  FibreOptions fibres;

  // Warn if the diagonals of two meshes differ by more than this factor: one of
  // them is likely in other units.
  double scale_warning_ratio = 100;

  PrepareOptions() { fibres.fibres = 0; }
  bool IsValid(std::string* error) const;
};

// A mesh file as it came and what was done to it.
struct MeshPreparation {
  std::string name;
  std::string path;
  MeshDefects defects;
  RepairReport repairs;
  SliverRemovals slivers;
};

struct PreparedMuscle {
  MeshPreparation mesh;
  MuscleModel model;
  bool hull_encloses = false;
  CarriedLines lines;   // the action lines, at the places of the samples
  CarriedLines fibres;  // none unless asked for
  double fibres_ms = 0;
};

struct PreparedBone {
  MeshPreparation mesh;
  std::string body;
  TriangleSoup rest;
};

// A scene with its meshes read, repaired and analysed, and lines made where
// there were none. Constant from then on.
struct PreparedScene {
  Scene scene;
  std::vector<PreparedMuscle> muscles;
  std::vector<PreparedBone> bones;
  std::vector<ExemptArea> exempt;  // areas of attachment that may penetrate
  std::vector<std::string> warnings;
  double wall_ms = 0;
};

// Throws InputError if a mesh cannot be read or repaired. `on_progress` may be
// empty. Precondition (CHECKed): the options are valid.
PreparedScene PrepareScene(const Scene& scene,
                           const PrepareOptions& options,
                           const ProgressCallback& on_progress = {});

}  // namespace musclewarp
