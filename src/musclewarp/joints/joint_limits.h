// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/arm_limits.h"
#include "musclewarp/joints/foot_limits.h"
#include "musclewarp/joints/leg_limits.h"

namespace musclewarp {

// Signs that compare both sides of the body.
struct SidesLimits {
  JointSign radius =
      Above(10)
          .Weak(
              "the radii of the right and the left {shape} differ: {right} "
              "and {left} mm, {limit} % at most are expected")
          .From("one side is cut",
                "not measured; the knees of TLEM2 differ by 10.4 %");
};

constexpr auto FieldsOf(Described<SidesLimits>) {
  return std::make_tuple(
      Field(&SidesLimits::radius, "radius", "%")
          .Text("the radii of the right and the left joint differ"));
}

// All signs on which verdicts depend. docs/joints.md has a table of them, which
// scripts/generated.py makes.
struct JointLimits {
  HipLimits hip;
  KneeLimits knee;
  PatellaLimits patella;
  AnkleLimits ankle;
  SubtalarLimits subtalar;
  ShoulderLimits shoulder;
  ElbowLimits elbow;
  ForearmLimits forearm;
  SidesLimits sides;
};

constexpr auto FieldsOf(Described<JointLimits>) {
  using F = JointLimits;
  return std::make_tuple(
      Field(&F::hip, "hip").Text("head of the femur and its socket"),
      Field(&F::knee, "knee").Text("posterior condyles of the femur"),
      Field(&F::patella, "patella").Text("groove of the femur"),
      Field(&F::ankle, "ankle").Text("dome of the talus"),
      Field(&F::subtalar, "subtalar").Text("head and facet of the talus"),
      Field(&F::shoulder, "shoulder").Text("head of the humerus"),
      Field(&F::elbow, "elbow").Text("trochlea and capitulum"),
      Field(&F::forearm, "forearm").Text("line from ulna to radius"),
      Field(&F::sides, "all").Text("right and left of one person"));
}

inline constexpr JointLimits kJointLimits = {};

}  // namespace musclewarp
