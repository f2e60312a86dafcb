// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"

namespace musclewarp {

// What a certified frame has to hold beside that nothing crosses: which frames
// count as usable is decided here.
struct FrameRequirements {
  // |volume ratio - 1| of a muscle.
  double max_volume_error = 4e-4;

  // Folded triangles of a muscle, as a share of its triangles.
  double max_folded_share = 1e-3;

  // Contact may move a vertex by this factor of the depths along the chain of
  // muscles that push it (push_chains.h), and by the allowance (mm) beside
  // that. Muscles that are nearer to each other than this, mm, pass a push on.
  double touching_distance = 0.5;
  double displacement_per_depth = 2;
  double displacement_allowance = 1;

  // The proved distance of every two meshes, mm, at most kMeshGapLimit; 0 if
  // none is required. Certified contact requires at least the gap that it
  // keeps.
  double gap = 0;

  bool IsValid(std::string* error) const;
};

// What is measured of one muscle in a frame, for the certificate.
struct MuscleMeasures {
  std::string name;
  double volume_ratio = 0;  // to the volume at rest
  int num_triangles = 0;
  int folded_triangles = 0;

  // Pairs of its triangles that cross each other: in the frame, and in the mesh
  // as it was delivered and repaired, which is the baseline.
  int self_pairs = 0;
  int self_pairs_at_rest = 0;

  // How far contact moved a vertex at most, mm, how deep the muscle is in
  // another mesh, or another in it, without contact, mm, and the depths along
  // the chain of muscles that push it (their names, it comes last).
  double max_contact_displacement = 0;
  double depth_without_contact = 0;
  double push_depth = 0;
  std::vector<std::string> pushed_by;
};

// Returns what a frame does not hold of the requirements, a sentence each:
// triangles that cross (how many, where, how deep), vertices inside another
// mesh, gaps, volume, self-intersections (no more than at rest), folded
// triangles, displacement. A frame is certified if there are none. Precondition
// (CHECKed): the requirements are valid.
std::vector<std::string> Shortcomings(
    const FrameRequirements& requirements,
    const SceneIntersections& intersections,
    const std::vector<MuscleMeasures>& muscles);

}  // namespace musclewarp
