// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of the searches for joints, each with what it is and why it is
// so. Lengths that follow the size of a person are in radii of the head of the
// femur. Limits of verdicts are in joint_limits.h.

#include "musclewarp/base/described.h"
#include "musclewarp/joints/bone_search.h"
#include "musclewarp/joints/facing_surface.h"
#include "musclewarp/joints/fit_search.h"
#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

constexpr auto FieldsOf(Described<SurfaceSampling>) {
  using F = SurfaceSampling;
  return std::make_tuple(
      Field(&F::spacing, "spacing", "mm")
          .Text("between neighbouring points; on vertices the knee of "
                "BodyParts3D was 12 degrees off, on points it is 2"),
      Field(&F::normal_radius, "normal_radius", "mm")
          .Text("normals are averaged over this: about two points, and a voxel "
                "of most images"),
      Field(&F::stray_fraction, "stray_fraction", "of the area")
          .Text("smaller pieces are left out: crumbs of a segmentation"));
}

constexpr auto FieldsOf(Described<FacingLimits>) {
  using F = FacingLimits;
  return std::make_tuple(
      Field(&F::reach, "reach", "mm")
          .Text("to the other bone: cartilage keeps bones 2 to 5 mm apart"),
      Field(&F::least_cosine, "least_cosine", "cosine")
          .Text(
              "of the normal and the direction to the other bone: 46 degrees"),
      Field(&F::least_opposition, "least_opposition", "cosine")
          .Text("of both normals: within 60 degrees of opposite"));
}

// What belongs together in a body.
struct BodySearch {
  double second_triangle = 0.95;
  double one_hip_bone = 3.1;
  double end_part = 0.04;
  double nearby = 60;
  double off_middle = 10;
  double least_human = 0.3;
  double largest_human = 2;
  double least_size = 1.0 / 64;
};

constexpr auto FieldsOf(Described<BodySearch>) {
  using F = BodySearch;
  return std::make_tuple(
      Field(&F::second_triangle, "second_triangle", "of the area")
          .Text("the second largest triangle of a pelvis may be the front one "
                "if it is so large: wide or damaged pelves; not measured"),
      Field(&F::one_hip_bone, "one_hip_bone", "radii")
          .Text("the head is nearer to the middle of one hip bone, and farther "
                "from that of a pelvis: 2.3, and 4.2 to 4.7 (LHDL, TLEM2)"),
      Field(&F::end_part, "end_part", "of the length")
          .Text("farthest part of an ulna, whose middle is that of its head: "
                "about 10 mm; not measured"),
      Field(&F::nearby, "nearby", "mm")
          .Text(
              "neighbouring bones of one limb are nearer to each other; those "
              "of two limbs are not compared beyond"),
      Field(&F::off_middle, "off_middle", "mm")
          .Text("a bone nearer to the middle of the body has no side by its "
                "place, as the middle is not exact"),
      Field(&F::least_human, "least_human", "adults")
          .Text("size of the smallest human skeleton: a newborn child"),
      Field(&F::largest_human, "largest_human", "adults")
          .Text("size that no human skeleton has"),
      Field(&F::least_size, "least_size", "adults")
          .Text("size of the smallest animal: smaller bones are in another "
                "unit"));
}

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

constexpr auto FieldsOf(Described<JointSearch>) {
  using F = JointSearch;
  return std::make_tuple(
      Field(&F::sampling, "sampling").Text("points on bones"),
      Field(&F::facing, "facing").Text("surfaces of a joint"),
      Field(&F::fit, "fit").Text("votes and fits"),
      Field(&F::head, "head").Text("heads and shafts"),
      Field(&F::knee, "knee").Text("condyles"),
      Field(&F::talus, "talus").Text("talus"),
      Field(&F::patella, "patella").Text("groove and tuberosity"),
      Field(&F::body, "body").Text("bones of one body"));
}

inline constexpr JointSearch kJointSearch = {};

}  // namespace musclewarp
