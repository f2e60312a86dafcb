// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The signs of the joints of an arm (joint_sign.h), which have no reference
// joints yet.

#include "musclewarp/joints/joint_sign.h"

namespace musclewarp {

struct ShoulderLimits {
  JointSign coverage =
      Below(35, 27)
          .Weak(
              "the head covers {value} % of its sphere, {limit} % or more "
              "are expected: it is cut")
          .Failed(
              "no head on the humerus: the best sphere of "
              "{least_head_radius} to {largest_head_radius} mm covers "
              "{value} % of itself, {limit} % or more are needed; are the "
              "meshes in mm, and is the upper end of the humerus there")
          .From("a head that is cut; meshes not in mm",
                "a head is half a ball; that of BodyParts3D covers 42 %");
  JointSign spread =
      Above(0.8)
          .Digits(1)
          .Weak(
              "the head is off its sphere by {value} mm, at most {limit} mm "
              "are expected")
          .From("a deformed head, or a coarse mesh",
                "as for the hip; BodyParts3D has 0.5 mm");
  JointSign no_axes =
      WeakIf(
          "the axes of the image are not known: those of the file are taken "
          "for forward, up and right")
          .From("`{axes}=none`, or an image without directions",
                "needs no limit");
};

constexpr auto FieldsOf(Described<ShoulderLimits>) {
  using F = ShoulderLimits;
  return std::make_tuple(
      Field(&F::coverage, "coverage", "%")
          .Text("the head covers so little of its sphere"),
      Field(&F::spread, "spread", "mm").Text("the head is off its sphere"),
      Field(&F::no_axes, "no_axes")
          .Text("the axes of the image are not known"));
}

struct ElbowLimits {
  JointSign angle =
      Below(120, 60)
          .Weak(
              "the humerus looks at the forearm over {value} degrees, "
              "{limit} or more are expected")
          .Failed(
              "the humerus looks at the forearm over {value} degrees, "
              "{limit} or more are needed: {cause}")
          .From("bones from two scans, or of two arms", "not measured");
  JointSign spread =
      Above(1.5)
          .Digits(1)
          .Weak(
              "normals pass the axis by {value} mm, {limit} mm or less is "
              "expected")
          .From("a coarse mesh", "not measured");
  JointSign no_right =
      WeakIf(
          "neither a radius nor the image tells where the right is: flexion "
          "may go backwards")
          .From("an arm without radius, with `{axes}=none`", "needs no limit");
};

constexpr auto FieldsOf(Described<ElbowLimits>) {
  using F = ElbowLimits;
  return std::make_tuple(
      Field(&F::angle, "angle", "degrees")
          .Text("the humerus looks at the forearm over so small an angle"),
      Field(&F::spread, "spread", "mm").Text("normals pass the axis"),
      Field(&F::no_right, "no_right")
          .Text("neither a radius nor the image tells where the right is"));
}

struct ForearmLimits {
  JointSign not_facing =
      Below({}, 10)
          .Failed(
              "the head of the radius does not look at the humerus within "
              "{reach} mm: {cause}")
          .From("bones from two scans, or cut", "not measured");
};

constexpr auto FieldsOf(Described<ForearmLimits>) {
  using F = ForearmLimits;
  return std::make_tuple(
      Field(&F::not_facing, "not_facing", "points")
          .Text("so little of the head of the radius looks at the humerus "
                "within {reach} mm, by points of {spacing} mm"));
}

}  // namespace musclewarp
