// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The signs of the joints below the tibia (joint_sign.h). Sources name the
// bones of benchmarks/joint_accuracy.md.

#include "musclewarp/joints/joint_sign.h"

namespace musclewarp {

// In all four cases of the dome the joint is weak, and the height of the axis
// is that of the tips of the malleoli.
struct AnkleLimits {
  JointSign not_facing =
      FailedIf(
          "no part of the talus looks at the tibia within {reach} mm: "
          "{cause}")
          .From("bones from two scans, or of two legs", "needs no limit");
  JointSign angle =
      Below(60)
          .Weak(
              "the dome of the talus covers {value} degrees of a cylinder of "
              "{value2} mm, is off it by {value3} mm, and the tips of the "
              "malleoli are {value4} mm above or below its axis; {limit} "
              "degrees or more, {limit2}, {limit3} and {limit4} mm or less "
              "are expected: {cause}{height}")
          .From("a dome flattened by thick slices",
                "domes of LHDL and BodyParts3D cover 160 and 135 degrees, "
                "those of TLEM2 100 and 110");
  JointSign radius = Above(1.25).Digits(1).From(
      "the same",
      "the flattened domes of TLEM2, off by 6 to 7 mm, have 1.3 to 1.4; LHDL, "
      "off by 1.6 mm, has 0.9, BodyParts3D 0.8");
  JointSign spread = Above(0.5).Digits(2).From(
      "the same", "TLEM2 has 0.6 mm, LHDL and BodyParts3D 0.4 mm");
  JointSign height = Above(0.25).Digits(1).From(
      "the same; in all four cases the height of the axis is that of the tips, "
      "if the fibula is there",
      "TLEM2 has 0.8, LHDL and BodyParts3D are good; LHDL as voxels of 3 mm, "
      "off by 3 mm, is weak");
};

constexpr auto FieldsOf(Described<AnkleLimits>) {
  using F = AnkleLimits;
  return std::make_tuple(
      Field(&F::not_facing, "not_facing")
          .Text("no part of the talus looks at the tibia within {reach} mm"),
      Field(&F::angle, "angle", "degrees")
          .Text("the dome covers so little about its axis"),
      Field(&F::radius, "radius", "radii")
          .Text("the radius of the dome, by that of the head of the femur "
                "({usual_head_radius} mm if there is none)"),
      Field(&F::spread, "spread", "mm").Text("the dome is off its cylinder"),
      Field(&F::height, "height", "radii")
          .Text("the tips of the malleoli are above or below the axis, by the "
                "radius of the head"));
}

struct SubtalarLimits {
  JointSign no_spheres =
      FailedIf(
          "no spheres fit the head of the talus and its facet above the "
          "heel bone: the navicular or the heel bone is not there, or a "
          "bone is of another scan")
          .From(
              "the navicular or the heel bone is not there, or is from "
              "another scan",
              "needs no limit");
  JointSign facet =
      Below(250)
          .Weak(
              "only {value} mm2 of the talus look at the heel bone as a "
              "hollow sphere, {limit} mm2 or more are expected: {cause}")
          .From("bones too far apart, or a coarse mesh",
                "LHDL, within 3 degrees, is good; TLEM2, off by 8 and 11 "
                "degrees, has 203 and 125 mm2, BodyParts3D 168 mm2");
  JointSign distance =
      Below(1.4)
          .Weak(
              "the centres of both spheres are only {value} mm apart, "
              "{limit} mm or more are expected")
          .From("the same",
                "the angle of the axis is uncertain by that of a centre over "
                "this distance; five of six wrong axes of TLEM2 are weak");
};

constexpr auto FieldsOf(Described<SubtalarLimits>) {
  using F = SubtalarLimits;
  return std::make_tuple(
      Field(&F::no_spheres, "no_spheres")
          .Text("spheres do not fit the head and the facet"),
      Field(&F::facet, "facet", "mm2")
          .Text("so little of the facet looks at the heel bone"),
      Field(&F::distance, "distance", "radii")
          .Text("the centres of both spheres are near each other, by the "
                "radius of the head of the femur"));
}

}  // namespace musclewarp
