// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// What happens to muscles that cannot be separated from bones and from each
// other by moving their vertices: because a bone cuts a part off, or a tendon
// lies inside a bone.
enum class ReconstructionKind {
  kAuto,   // their meshes are made anew (CellSurface)
  kNever,  // the scene is refused
};

struct ReconstructionOptions {
  ReconstructionKind kind = ReconstructionKind::kAuto;

  // New surfaces keep the margin of medial cells from bones and from each other
  // (MedialCellOptions::margin). It grows by this factor, so many times, while
  // a surface crosses a bone, as bones may have details between its samples;
  // and once with each further attempt to separate the new surfaces.
  double margin_growth = 3;
  int max_growths = 2;

  // The margin of a surface does not grow so far that more than this share of
  // its volume is lost: there would be little left of a thin muscle.
  double max_loss_by_margin = 0.25;

  int max_attempts = 3;

  // The distance of the samples of a surface, as a share of the typical edge of
  // the old mesh, and its limits, mm.
  double spacing_share = 0.5;
  double min_spacing = 0.4;
  double max_spacing = 1.5;

  // At least so many samples across the mean thickness of a muscle, unless they
  // would be nearer than min_spacing.
  double samples_across = 4;

  // Less than this share of a muscle's volume must not be left before it grows
  // on its free sides. Two muscles that overlap by most of their thickness keep
  // half of it each.
  double least_volume_share = 0.25;

  bool IsValid(std::string* error) const;
};

// Makes the frame solver of a scene, and sees to it that its rest pose is
// clean: if with certified contact triangles still cross in it, or a muscle
// crosses itself, the meshes of those muscles are made anew from what belongs
// to them (their medial cells), and the solver is made again. Adds warnings to
// the scene that say what was made anew. Throws InputError, with the places, if
// the rest pose does not become clean, or if a mesh would have to be made anew
// but must not be. Precondition (CHECKed): all options are valid.
std::unique_ptr<FrameSolver> MakeCleanFrameSolver(
    const ReconstructionOptions& reconstruction,
    const PrepareOptions& prepare,
    const FrameSolverOptions& options,
    const MuscleSolvers& solvers,
    const ProgressCallback& on_progress,
    PreparedScene* scene);

}  // namespace musclewarp
