// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of the searches for joints, each with what it is and why it is
// so. Lengths that follow the size of a person are in radii of the head of the
// femur. Limits of verdicts are in joint_limits.h.

#include "musclewarp/joints/bone_search.h"
#include "musclewarp/joints/facing_surface.h"
#include "musclewarp/joints/fit_search.h"
#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

// What belongs together in a body.
struct BodySearch {
  // The second largest triangle of a pelvis may be the front one if it is so
  // large: wide or damaged pelves; not measured (of the area).
  double second_triangle = 0.95;

  // The head is nearer to the middle of one hip bone, and farther from that of
  // a pelvis: 2.3, and 4.2 to 4.7 (LHDL, TLEM2) (radii of the head).
  double one_hip_bone = 3.1;

  // Farthest part of an ulna, whose middle is that of its head: about 10 mm;
  // not measured (of the length).
  double end_part = 0.04;

  // Neighbouring bones of one limb are nearer to each other; those of two
  // limbs are not compared beyond (mm).
  double nearby = 60;

  // A bone nearer to the middle of the body has no side by its place, as the
  // middle is not exact (mm).
  double off_middle = 10;

  // Size of the smallest human skeleton: a newborn child (adults).
  double least_human = 0.3;

  // Size that no human skeleton has (adults).
  double largest_human = 2;

  // Size of the smallest animal: smaller bones are in another unit (adults).
  double least_size = 1.0 / 64;
};

// The numbers of all searches.
struct JointSearch {
  SurfaceSampling sampling;
  FacingLimits facing;
  FitNumbers fit;
  HeadSearch head;
  KneeSearch knee;
  TalusSearch talus;
  PatellaSearch patella;
  BodySearch body;
};

inline constexpr JointSearch kJointSearch = {};

}  // namespace musclewarp
