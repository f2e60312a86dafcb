// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of searches on single bones (joint_search.h).

#include "musclewarp/base/described.h"

namespace musclewarp {

// The condyles of a femur.
struct KneeSearch {
  double least_condyle = 0.7;
  double largest_condyle = 1.2;
  double condyle_height = 2.2;
  double first_normal = 12;
  double last_normal = 120;
  double condyle_slant = 0.7;
  double start_tilt = 7;
  int starts = 10;
  double condyle_reach = 2;
  double ankle_part = 0.05;
};

constexpr auto FieldsOf(Described<KneeSearch>) {
  using F = KneeSearch;
  return std::make_tuple(
      Field(&F::least_condyle, "least_condyle", "radii")
          .Text("radius of posterior condyles: BodyParts3D has 0.9"),
      Field(&F::largest_condyle, "largest_condyle", "radii").Text("the same"),
      Field(&F::condyle_height, "condyle_height", "radii")
          .Text("condyles are looked for up to this height above the lowest "
                "point: nearly twice their largest radius"),
      Field(&F::first_normal, "first_normal", "degrees")
          .Text("from down to back, of the surface that rolls on the tibia: "
                "what is before is flatter"),
      Field(&F::last_normal, "last_normal", "degrees")
          .Text("the same: what is above belongs to the shaft"),
      Field(&F::condyle_slant, "condyle_slant", "cosine")
          .Text("largest part of a normal to left or right: the sides of "
                "condyles look outwards"),
      Field(&F::start_tilt, "start_tilt", "degrees")
          .Text("directions of starts are so far off the widest direction of "
                "the lower end, as the axis may be"),
      Field(&F::starts, "starts")
          .Text("how many are fitted: the best one alone was 8 and 15 degrees "
                "off in 2 of 39 runs"),
      Field(&F::condyle_reach, "condyle_reach", "mm")
          .Text("points so near to the cylinder belong to it in the last "
                "rounds; not measured"),
      Field(&F::ankle_part, "ankle_part", "of the length")
          .Text("lowest part of a tibia, whose middle is that of the ankle"));
}

// The dome, head and facet of a talus.
struct TalusSearch {
  double dome_slant = 0.4;
  double dome_up = 0.5;
  double whole_dome_up = 0.26;
  int dome_directions = 12;
  double dome_first_reach = 6;
  double least_talus_head = 8;
  double largest_talus_head = 30;
  double least_facet = 10;
  double largest_facet = 45;
  double highest_outer_tip = 5;
};

constexpr auto FieldsOf(Described<TalusSearch>) {
  using F = TalusSearch;
  return std::make_tuple(
      Field(&F::dome_slant, "dome_slant", "cosine")
          .Text("largest part of a normal along the axis of the dome: its "
                "sides look at the malleoli"),
      Field(&F::dome_up, "dome_up", "cosine")
          .Text(
              "least part of a normal of the dome upwards: within 60 degrees"),
      Field(&F::whole_dome_up, "whole_dome_up", "cosine")
          .Text("the dome ends 75 degrees before and behind its top"),
      Field(&F::dome_directions, "dome_directions")
          .Text("of axes that start a fit, in half a turn: every 15 degrees"),
      Field(&F::dome_first_reach, "dome_first_reach", "mm")
          .Text("points so near to a start are fitted: starts have radii of "
                "14, 20 and 28 mm"),
      Field(&F::least_talus_head, "least_talus_head", "mm")
          .Text("radius of the head of the talus: BodyParts3D has 16 mm"),
      Field(&F::largest_talus_head, "largest_talus_head", "mm")
          .Text("largest radius; not measured"),
      Field(&F::least_facet, "least_facet", "mm")
          .Text("radius of its facet above the heel bone: BodyParts3D has "
                "15 mm"),
      Field(&F::largest_facet, "largest_facet", "mm")
          .Text("largest radius; not measured"),
      Field(&F::highest_outer_tip, "highest_outer_tip", "mm")
          .Text("of the outer malleolus above the inner one, than which it is "
                "lower: else the fibula is not there"));
}

// The groove of the femur in which the patella glides, seen along the axis of
// the knee, and the tuberosity of the tibia.
struct PatellaSearch {
  double half_strip = 4;
  double groove_slant = 0.5;
  double groove_forward = 0.2;
  double groove_above = 25;
  double groove_below = 40;
  double groove_radius = 25;
  int groove_points = 40;
  double tuberosity_from = 30;
  double tuberosity_to = 80;
  double knee_step = 5;
  double beyond_range = 15;
};

constexpr auto FieldsOf(Described<PatellaSearch>) {
  using F = PatellaSearch;
  return std::make_tuple(
      Field(&F::half_strip, "half_strip", "mm")
          .Text("the groove reaches so far to both sides of the middle of the "
                "patella: its floor only; not measured"),
      Field(&F::groove_slant, "groove_slant", "cosine")
          .Text("largest part of a normal to the side: within 60 degrees"),
      Field(&F::groove_forward, "groove_forward", "cosine")
          .Text("least part of a normal forward: the underside of the condyles "
                "looks down"),
      Field(&F::groove_above, "groove_above", "mm")
          .Text("it reaches so far above the axis of the knee, as the condyles "
                "do"),
      Field(&F::groove_below, "groove_below", "mm")
          .Text("and so far below it, beyond the largest condyles"),
      Field(&F::groove_radius, "groove_radius", "mm")
          .Text("that starts the fit; the result does not depend on it"),
      Field(&F::groove_points, "groove_points")
          .Text("a fit needs so many: 58 mm2 of the strip; not measured"),
      Field(&F::tuberosity_from, "tuberosity_from", "mm")
          .Text("the tuberosity begins so far below the axis of the knee, "
                "under the plateau"),
      Field(&F::tuberosity_to, "tuberosity_to", "mm")
          .Text("and ends so far below it; not measured"),
      Field(&F::knee_step, "knee_step", "degrees")
          .Text("the angle of the patella is computed every so many degrees of "
                "the knee; between them it is linear"),
      Field(&F::beyond_range, "beyond_range", "degrees")
          .Text("and so far beyond its range, for motions that leave it"));
}

}  // namespace musclewarp
