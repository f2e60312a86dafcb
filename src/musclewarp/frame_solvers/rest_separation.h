// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/progress.h"
#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/muscle_solvers.h"
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
  double spacing_fraction = 0.5;
  double min_spacing = 0.4;
  double max_spacing = 1.5;

  // At least so many samples across the mean thickness of a muscle, unless they
  // would be nearer than min_spacing.
  double samples_across = 4;

  // Less than this share of a muscle's volume must not be left before it grows
  // on its free sides. Two muscles that overlap by most of their thickness keep
  // half of it each.
  double least_volume_fraction = 0.25;

  bool IsValid(std::string* error) const;
};

struct RestSeparationOptions {
  CertifiedContactOptions contact;
  PreRotationOptions pre_rotation;

  // What a muscle must hold to not count as displaced.
  FrameRequirements requirements;

  // How meshes that are made anew are prepared.
  PrepareOptions prepare;
  ReconstructionOptions reconstruction;

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

// Separates the meshes of a scene in its rest pose: vertices of muscles move as
// little as it takes for no triangles to cross. If some do all the same, or if
// a muscle crosses itself, the meshes of those muscles are made anew from what
// belongs to them (their medial cells), and all is separated again. The scene
// then has the new meshes, what crossed before (as_delivered), and warnings
// that say what was made anew. `solver` solves for coarse meshes;
// `on_progress` may be empty.
//
//   PreparedScene scene = PrepareScene(ReadScene("hip.json", data_root), {});
//   const RestResult rest = SeparateRest({}, solver, {}, &scene);
//   Show(rest.state.points);  // in the order of contact
//
// Throws InputError, with the places, if the rest pose does not become clean,
// or if a mesh would have to be made anew but must not be. Precondition
// (CHECKed): the options are valid.
RestResult SeparateRest(const RestSeparationOptions& options,
                        const MuscleSolver& solver,
                        const ProgressCallback& on_progress,
                        PreparedScene* scene);

}  // namespace musclewarp
