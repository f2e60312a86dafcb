// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/progress.h"
#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/frame_solvers/drawn_out_triangles.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The treatment of muscles that cannot be separated from bones and each other
// by moving their vertices: a bone cuts a part off, or a tendon lies inside a
// bone.
enum class ReconstructionKind {
  kAuto,   // their meshes are reconstructed (CellSurface)
  kNever,  // the scene is rejected
};

// Options of the reconstruction of surfaces from medial cells, for muscles that
// moving vertices cannot separate.
struct ReconstructionOptions {
  ReconstructionKind kind = ReconstructionKind::kAuto;

  // New surfaces keep the margin of medial cells from bones and from each other
  // (MedialCellOptions::margin). The margin is multiplied by `margin_growth`,
  // at most `max_growths` times, while a surface crosses a bone, as bones may
  // have details between its samples; and once for each further attempt to
  // separate the new surfaces.
  double margin_growth = 3;
  int max_growths = 2;

  // The margin stops growing before a surface loses more than this fraction of
  // its volume, which protects thin muscles.
  double max_loss_by_margin = 0.25;

  // If true, muscles that are displaced beyond the requirements are
  // reconstructed.
  bool reconstructs_displaced = true;

  // The largest number of reconstructions, each followed by a separation.
  int max_attempts = 3;

  // The spacing of the samples of a surface, as a fraction of the typical edge
  // length of the old mesh, and its limits, mm.
  double spacing_fraction = 0.5;
  double min_spacing = 0.4;
  double max_spacing = 1.5;

  // While more thin parts of a muscle than this are lost, mm^2, the spacing is
  // halved, down to `least_spacing`, mm: its mean thickness says nothing of a
  // tendon.
  double max_lost_thin_area = 30;
  double least_spacing = 0.3;
  double bridge = 1.25;  // CellSurfaceOptions::bridge from then on

  // The smallest number of samples across the mean thickness of a muscle,
  // unless their spacing would be less than `min_spacing`.
  double samples_across = 4;

  // The smallest admissible fraction of a muscle's volume in its cell, before
  // the surface grows on its free sides. Two muscles that overlap by most of
  // their thickness keep half of it each.
  double least_volume_fraction = 0.25;

  bool IsValid(std::string* error) const;
};

// Options of SeparateRest.
struct RestSeparationOptions {
  CertifiedContactOptions contact;
  PreRotationOptions pre_rotation;

  // The requirements that determine whether a muscle counts as displaced.
  FrameRequirements requirements;

  // The preparation of reconstructed meshes.
  PrepareOptions prepare;
  ReconstructionOptions reconstruction;

  // The removal of triangles that the separation draws out, at most
  // `max_retriangulations` times, each followed by at most `relaxing_steps`
  // steps.
  DrawnOutOptions drawn_out;
  int max_retriangulations = 3;
  int relaxing_steps = 4;

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

// Separates the meshes of a scene in its rest pose: vertices of muscles move as
// little as necessary until no triangles cross. Muscles that still cross a
// bone, another muscle or themselves, or that are displaced beyond the
// requirements, are reconstructed from their medial cells, and all meshes are
// separated again. Finally the triangles that the separation has drawn out are
// removed (rest_retriangulation.h). The scene then holds the new meshes, the
// earlier intersections (as_delivered) and a warning per reconstructed mesh.
// `solver` solves for coarse meshes; `on_progress` may be empty.
//
//   PreparedScene scene = PrepareScene(ReadScene("hip.json", data_root), {});
//   const RestResult rest = SeparateRest({}, solver, {}, &scene);
//   Show(rest.state.points);  // in the order of contact
//
// Throws InputError, with the places, if crossings remain after the last
// attempt, or after the separation if reconstruction is disabled; and if too
// little of a muscle is left for a reconstruction, or a mesh needs too much
// memory. Precondition (CHECKed): the options are valid.
RestResult SeparateRest(const RestSeparationOptions& options,
                        const MuscleSolver& solver,
                        const ProgressCallback& on_progress,
                        PreparedScene* scene);

}  // namespace musclewarp
