// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of searches on single bones (joint_search.h).

namespace musclewarp {

// The condyles of a femur.
struct KneeSearch {
  // Radius of posterior condyles: BodyParts3D has 0.9 (radii of the head).
  double least_condyle = 0.7;
  double largest_condyle = 1.2;

  // Condyles are looked for up to this height above the lowest point: nearly
  // twice their largest radius (radii of the head).
  double condyle_height = 2.2;

  // First normal of the surface that rolls on the tibia, from down to back:
  // what is before it is flatter (degrees).
  double first_normal = 12;

  // Last normal of that surface: what is above it belongs to the shaft
  // (degrees).
  double last_normal = 120;

  // Largest part of a normal to left or right: the sides of condyles look
  // outwards (cosine).
  double condyle_slant = 0.7;

  // Directions of starts are so far off the widest direction of the lower end,
  // as the axis may be (degrees).
  double start_tilt = 7;

  // Number of starts that are fitted: the best one alone was 8 and 15 degrees
  // off in 2 of 39 runs.
  int starts = 10;

  // Points so near to the cylinder belong to it in the last rounds; not
  // measured (mm).
  double condyle_reach = 2;

  // Lowest part of a tibia, whose middle is that of the ankle (of the length).
  double ankle_part = 0.05;
};

// The dome, head and facet of a talus.
struct TalusSearch {
  // Largest part of a normal along the axis of the dome: its sides look at the
  // malleoli (cosine).
  double dome_slant = 0.4;

  // Least part of a normal of the dome upwards: within 60 degrees (cosine).
  double dome_up = 0.5;

  // The dome ends 75 degrees before and behind its top (cosine).
  double whole_dome_up = 0.26;

  // Number of axes that start a fit, in half a turn: every 15 degrees.
  int dome_directions = 12;

  // Points so near to a start are fitted: starts have radii of 14, 20 and 28
  // mm.
  double dome_first_reach = 6;

  // Radius of the head of the talus: BodyParts3D has 16 mm.
  double least_talus_head = 8;

  // Largest radius; not measured (mm).
  double largest_talus_head = 30;

  // Radius of its facet above the heel bone: BodyParts3D has 15 mm.
  double least_facet = 10;

  // Largest radius; not measured (mm).
  double largest_facet = 45;

  // Of the outer malleolus above the inner one, than which it is lower: else
  // the fibula is not there (mm).
  double highest_outer_tip = 5;
};

// The groove of the femur in which the patella glides, seen along the axis of
// the knee, and the tuberosity of the tibia.
struct PatellaSearch {
  // The groove reaches so far to both sides of the middle of the patella: its
  // floor only; not measured (mm).
  double half_strip = 4;

  // Largest part of a normal to the side: within 60 degrees (cosine).
  double groove_slant = 0.5;

  // Least part of a normal forward: the underside of the condyles looks down
  // (cosine).
  double groove_forward = 0.2;

  // It reaches so far above the axis of the knee, as the condyles do (mm).
  double groove_above = 25;

  // And so far below it, beyond the largest condyles (mm).
  double groove_below = 40;

  // That starts the fit; the result does not depend on it (mm).
  double groove_radius = 25;

  // A fit needs so many: 58 mm2 of the strip; not measured.
  int groove_points = 40;

  // The tuberosity begins so far below the axis of the knee, under the plateau
  // (mm).
  double tuberosity_from = 30;

  // And ends so far below it; not measured (mm).
  double tuberosity_to = 80;

  // The angle of the patella is computed every so many degrees of the knee;
  // between them it is linear (degrees).
  double knee_step = 5;

  // And so far beyond its range, for motions that leave it (degrees).
  double beyond_range = 15;
};

}  // namespace musclewarp
