// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The signs of the joints of a leg (joint_sign.h). Sources name the bones of
// benchmarks/joint_accuracy.md: LHDL (CT), TLEM2 (MRI) and BodyParts3D.

#include "musclewarp/joints/bone_search.h"
#include "musclewarp/joints/joint_sign.h"

namespace musclewarp {

struct HipLimits {
  JointSign coverage =
      Below(45, 30)
          .Weak(
              "the head covers {value} % of its sphere, {limit} % or more "
              "are expected: it is cut by the image, or a part of it is "
              "labelled as hip bone")
          .Failed(
              "no head on the femur: the best sphere of "
              "{least_head_radius} to {largest_head_radius} mm covers "
              "{value} % of itself, {limit} to {limit2} % are needed; are "
              "the meshes in mm, and is the upper end of the femur there")
          .From(
              "meshes not in mm; the upper end of the femur is cut by the "
              "image, or a part of the head is labelled as hip bone",
              "whole heads cover 58 to 64 %, heads without their medial third "
              "33 to 37 %, the next best place of a femur up to 24 %");
  JointSign ball = Above({}, 95).From("a mesh that is a ball",
                                      "by geometry: a head has a neck");
  JointSign spread =
      Above(0.8)
          .Digits(1)
          .Weak(
              "the head is off its sphere by {value} mm, at most {limit} mm "
              "are expected: {cause}")
          .From("a deformed head, or a coarse mesh",
                "heads of all three persons have 0.4 to 0.5 mm");
  JointSign distance =
      Above({}, 1.6)
          .Failed(
              "the hip bone is {value} mm away from the centre of the "
              "head, {limit} mm or less are needed: {cause}")
          .From("bones from two scans",
                "by geometry: sockets have 1 to 1.2 radii. LHDL with its femur "
                "moved by 100 mm fails");
  JointSign no_socket =
      WeakIf("no socket was found about the head of the femur: {cause}")
          .From("bones from two scans, or a hip bone that is cut",
                "needs no limit");
  JointSign offset =
      Above(3)
          .Digits(1)
          .Weak(
              "the socket is {value} mm off the head, at most {limit} mm are "
              "expected: {cause}")
          .From("bones from two scans, or a dislocation",
                "LHDL is good; BodyParts3D has 3.7 mm, TLEM2, whose heads and "
                "sockets are apart, 5 and 6 mm");
  JointSign no_axes =
      WeakIf(
          "neither bones nor image say where forward and up are: the axes "
          "are those of the file")
          .From("one hip bone or half a femur, with `{axes}=none`",
                "needs no limit");
};

constexpr auto FieldsOf(Described<HipLimits>) {
  using F = HipLimits;
  return std::make_tuple(
      Field(&F::coverage, "coverage", "%")
          .Text("the best sphere of {least_head_radius} to "
                "{largest_head_radius} mm on the femur covers so little of "
                "itself"),
      Field(&F::ball, "ball", "%").Text("the same sphere covers all of itself"),
      Field(&F::spread, "spread", "mm")
          .Text("the head is off its sphere (root mean square)"),
      Field(&F::distance, "distance", "radii")
          .Text("the nearest point of the hip bone is away from the centre of "
                "the head"),
      Field(&F::no_socket, "no_socket").Text("no socket about the head"),
      Field(&F::offset, "offset", "mm")
          .Text("the centre of the socket is off that of the head"),
      Field(&F::no_axes, "no_axes")
          .Text("neither bones nor the image say where forward and up are"));
}

struct KneeLimits {
  JointSign no_cylinder =
      FailedIf(
          "no cylinder fits two condyles of the femur: its lower end is "
          "not there, or the meshes are not in mm")
          .From("no lower end; meshes not in mm", "needs no limit");
  JointSign back_to_front =
      Below({}, 1.5)
          .Digits(1)
          .Failed(
              "no condyles: the lower end reaches back {value} times as "
              "far as forward ({limit} or more are needed) and is {value2} "
              "radii of the head away from it ({limit2} or more): {cause}")
          .From(
              "a femur without its lower end",
              "whole femora of all three persons pass, their upper parts fail");
  JointSign length = Below({}, 8).Digits(1).From("the same", "the same");
  JointSign turn =
      Above({}, 30)
          .Failed(
              "no condyles: the cylinder that fits best is {value} degrees "
              "off the widest direction of the lower end, {limit} or less "
              "are needed")
          .From("no condyles",
                "by geometry: starts are within {start_tilt} degrees of that "
                "direction");
  JointSign sphere_angle =
      Above(5, 20)
          .Digits(1)
          .Weak(
              "spheres on both condyles give an axis that is {value} degrees "
              "off, {limit} or less are expected: {cause}")
          .Failed(
              "spheres on both condyles give an axis that is {value} "
              "degrees off, {limit} or less are needed")
          .From("osteophytes, or a coarse mesh",
                "knees of the benchmark within 2.4 degrees of their reference "
                "are good");
  JointSign angle =
      Below(60, 30)
          .Weak(
              "a condyle covers {value} degrees of its cylinder, {limit} or "
              "more are expected: cut or coarse bone")
          .Failed(
              "a condyle covers {value} degrees of its cylinder, {limit} "
              "or more are needed")
          .From("a cut or coarse bone",
                "condyles of all three persons cover 115 to 130 degrees; the "
                "wrong end of a lower half covered 10 degrees, the right one "
                "100");
  JointSign spread =
      Above(1)
          .Digits(1)
          .Weak(
              "the condyles are off their cylinder by {value} mm, {limit} mm "
              "or less is expected")
          .From("a coarse mesh, a worn joint",
                "condyles of all three persons have 0.6 to 0.8 mm");
  JointSign gap =
      Above({}, 2)
          .Failed(
              "the tibia is {value} mm away from the centre of the knee, "
              "{limit} mm or less are needed: of another leg or scan")
          .From("a tibia of another leg or scan",
                "by geometry: condyles have 0.7 to 1.2 radii of the head");
  JointSign is_up_unknown =
      WeakIf(
          "neither a head nor the image tells which end of the femur is up: "
          "the condyles may be looked at from the wrong side")
          .From("a piece of a femur, with `{axes}=none`",
                "knees of the lower quarter are then wrong by 4 to 9 degrees "
                "in all four legs of the benchmark");
};

constexpr auto FieldsOf(Described<KneeLimits>) {
  using F = KneeLimits;
  return std::make_tuple(
      Field(&F::no_cylinder, "no_cylinder")
          .Text("no cylinder fits two condyles"),
      Field(&F::back_to_front, "back_to_front", "times")
          .Text("the lower end reaches back so little farther than forward"),
      Field(&F::length, "length", "radii of the head")
          .Text("the lower end is so near to the head"),
      Field(&F::turn, "turn", "degrees")
          .Text("the cylinder is off the widest direction of the lower end"),
      Field(&F::sphere_angle, "sphere_angle", "degrees")
          .Text("spheres on both condyles give another axis"),
      Field(&F::angle, "angle", "degrees")
          .Text("a condyle covers so little about the axis"),
      Field(&F::spread, "spread", "mm")
          .Text("the condyles are off their cylinder"),
      Field(&F::gap, "gap", "radii of the head")
          .Text("the nearest point of the tibia is away from the centre of the "
                "knee"),
      Field(&F::is_up_unknown, "is_up_unknown")
          .Text("neither a head nor the image tells which end is up"));
}

struct PatellaLimits {
  JointSign no_knee =
      FailedIf("the knee that the patella follows was not found")
          .From("see knee", "needs no limit");
  JointSign no_groove =
      FailedIf(
          "the groove of the femur or the tuberosity of the tibia was not "
          "found behind and below the patella")
          .From("a tibia or femur that is cut", "needs no limit");
  JointSign spread =
      Above(1.5)
          .Digits(1)
          .Weak(
              "the groove is off its circle by {value} mm, {limit} mm or less "
              "are expected")
          .From("a coarse mesh",
                "grooves of LHDL and TLEM2 have 0.6 to 1.3 mm; patellae have "
                "no reference");
  JointSign held_back =
      Above(PatellaSearch().knee_step)
          .Weak(
              "the ligament holds the patella back from {reached} of the knee "
              "on: there it stays in its groove")
          .From("a short tibia, a patella far from its place",
                "not measured: the step at which the angle is computed");
};

constexpr auto FieldsOf(Described<PatellaLimits>) {
  using F = PatellaLimits;
  return std::make_tuple(
      Field(&F::no_knee, "no_knee").Text("the knee was not found"),
      Field(&F::no_groove, "no_groove")
          .Text("no groove behind it or no tuberosity below it"),
      Field(&F::spread, "spread", "mm").Text("the groove is off its circle"),
      Field(&F::held_back, "held_back", "degrees")
          .Text("the ligament holds the patella back before the knee is at the "
                "end of its range"));
}

}  // namespace musclewarp
