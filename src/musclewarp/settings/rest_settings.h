// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/frame_solvers/rest_separation.h"

namespace musclewarp {

// The settings of the separation of the rest pose, whether or not a motion
// follows.
struct RestSettings {
  double gap = StepOptions().gap;
  std::string remake = "auto";
  double max_hole = HoleLimits().max_perimeter;
  double max_loss = FrameRequirements().max_volume_loss;
  double max_lost_area = FrameRequirements().max_lost_area;
  double max_lost_extent = FrameRequirements().max_lost_extent;

  // The names of the settings that the user gave. The lengths and areas among
  // them, and those that differ from their default, are in mm of the scene; all
  // others follow the size of the body.
  std::set<std::string> given = {};
};

constexpr auto FieldsOf(Described<RestSettings>) {
  using S = RestSettings;
  return std::make_tuple(
      Field(&S::gap, "gap", "mm")
          .Text("distance that certified contact keeps between surfaces; the "
                "default follows the size of the body")
          .Above(0, kLargestGap),
      Field(&S::remake, "remake")
          .Text("what happens to meshes that cannot be separated by moving "
                "their vertices: auto (their surfaces are reconstructed) or "
                "never (the input is refused)")
          .OneOf("auto, never"),
      Field(&S::max_hole, "max_hole", "mm")
          .Text("longest border of a hole that is filled when a mesh is "
                "repaired; a longer one is filled if it is a missing face, or "
                "a slit: if the area of its filling is at most 0.006 times the "
                "square of the length of its border")
          .AtLeast(0),
      Field(&S::max_loss, "max_loss")
          .Text("share of the volume of a mesh or label, as delivered, that "
                "may be lost: pieces that are left out, and what a "
                "reconstruction cuts off; with more the result is not usable")
          .Within(0, 1),
      Field(&S::max_lost_area, "max_lost_area", "mm2")
          .Text("area of the surface of a mesh that a reconstruction may lose: "
                "farther than 3 mm, and twice the depth of the mesh in others, "
                "from the new surface; with more the result is not usable")
          .AtLeast(0),
      Field(&S::max_lost_extent, "max_lost_extent", "mm")
          .Text("length at an end of a mesh, beyond twice its depth in others, "
                "that a reconstruction may lose; with more the result is not "
                "usable")
          .AtLeast(0),
      NotWritten(&S::given));
}

// Sets the options that these settings mean, without a check of the values.
void SetOptions(const RestSettings& settings,
                PrepareOptions* prepare,
                CertifiedContactOptions* contact,
                FrameRequirements* requirements,
                ReconstructionOptions* reconstruction);

}  // namespace musclewarp
