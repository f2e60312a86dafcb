// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/figures/muscle_figures.h"
#include "musclewarp/figures/surface_reconstruction.h"

namespace musclewarp {

// What a certified frame has to hold beside that nothing crosses: which frames
// count as usable is decided here.
struct FrameRequirements {
  // How far the volume of a muscle may be off the one that the solver keeps, as
  // a share of it.
  double max_volume_error = 4e-4;

  // The share of the volume of a muscle, as it was delivered, that may be lost
  // to bones and other muscles, and to pieces of labels that are left out.
  double max_volume_loss = 0.06;

  // What of a muscle, as it was delivered, may be gone where its mesh was
  // reconstructed, whatever its volume: the area of surface that is farther
  // than 3 mm, and twice its depth in others, from the new one, mm^2, and the
  // length at one end, mm. No attachment may be lost.
  double max_lost_area = 100;
  double max_lost_extent = 5;

  // The largest stretch of a muscle's surface, as a ratio of lengths: beyond it
  // no data make sense. Muscles and tendons bear far less
  // (run/shape_warnings.h).
  double max_stretch = 20;

  // The largest patch of a muscle's surface that contact may tear, mm^2: beyond
  // twice its length at rest, and beyond what the pose asks for
  // (frames/triangle_stretch.h); 0 if none is forbidden.
  double max_torn_patch = 0;

  // Folded triangles of a muscle, as a share of its triangles.
  double max_folded_fraction = 1e-3;

  // Contact may move a vertex by this factor of the depth to which its muscle
  // is in another mesh without contact, by what the chain of muscles that push
  // it adds to that depth (push_chains.h), and by the allowance, mm.
  double displacement_per_depth = 2;
  double displacement_allowance = 1;

  // A displacement by contact that no frame is blamed for, mm: planes hold a
  // muscle that far off a rugged bone in which it is not deep.
  double least_displacement = 1.5;

  // Muscles that are nearer to each other than this, mm, at most kMeshGapLimit,
  // pass a push on.
  double touching_distance = 0.5;

  // The proved distance of every two meshes, mm, at most kMeshGapLimit; 0 if
  // none is required. Certified contact requires at least the gap that it
  // keeps.
  double gap = 0;

  // The unit of all lengths, mm (Scene::body_size), for the sentences.
  double body_size = 1;

  bool IsValid(std::string* error) const;
};

// A muscle of a frame as it is judged: its figures, and what preparing it took.
struct JudgedMuscle {
  MuscleFigures figures;
  double delivered_volume = 0;  // mm^3
  int num_triangles = 0;        // of the fine mesh
  SurfaceReconstruction reconstruction;

  // What is wrong with where its lines end, a sentence each.
  std::vector<std::string> missed_bones;
};

// Returns how far contact may move a vertex of a muscle, mm: what
// FrameRequirements says of the depths that were measured.
double LargestDisplacement(const FrameRequirements& requirements,
                           const MuscleFigures& muscle);

// Returns what is allowed in a frame: that, or the least_displacement if it is
// more.
double AllowedDisplacement(const FrameRequirements& requirements,
                           const MuscleFigures& muscle);

// Returns what muscles do not hold of the requirements by themselves, a
// sentence each: volume, stretch, and bones on which it does not end.
// Precondition (CHECKed): the requirements are valid.
std::vector<std::string> ShapeShortcomings(
    const FrameRequirements& requirements,
    const std::vector<JudgedMuscle>& muscles);

// Returns what a frame does not hold of the requirements, a sentence each:
// triangles that cross (how many, where, how deep), vertices inside another
// mesh, gaps, volume, stretch,
// self-intersections, folded triangles, displacement. A frame is certified if
// there are none. Precondition (CHECKed): the requirements are valid.
std::vector<std::string> Shortcomings(const FrameRequirements& requirements,
                                      const SceneIntersections& intersections,
                                      const std::vector<JudgedMuscle>& muscles);

// Returns a sentence for each crossing with a bone as it was delivered, which
// no certified frame has.
std::vector<std::string> DeliveredShortcomings(
    const std::vector<DeliveredCrossing>& crossings, double body_size);

}  // namespace musclewarp
