// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/proximity/surface_comparison.h"

namespace musclewarp {

// The settings of a comparison with a segmented posture.
struct PostureSettings {
  std::string posture;
  std::string mesh;
  std::string in;
  std::string frame;
  std::string muscle;
  double posture_spacing = SurfaceComparisonOptions().spacing;
};

constexpr const char* HeadingOf(Described<PostureSettings>) {
  return "Segmented posture";
}

constexpr auto FieldsOf(Described<PostureSettings>) {
  using S = PostureSettings;
  return std::make_tuple(
      Field(&S::posture, "posture")
          .Text("mesh of a muscle as segmented in a posture, with which "
                "{mesh}, or {muscle} in a {frame} of {in}, is compared")
          .Path(),
      Field(&S::mesh, "mesh")
          .Text("with {posture}, mesh file to compare")
          .Path(),
      Field(&S::in, "in")
          .Text("with {posture} or {literature}, folder of a run of "
                "musclewarp-deform")
          .Path(),
      Field(&S::frame, "frame")
          .Text("with {posture}, frame of {in}, last or a number; without it "
                "the last"),
      Field(&S::muscle, "muscle")
          .Text("with {posture}, muscle of {in} to compare"),
      Field(&S::posture_spacing, "posture_spacing", "mm")
          .Text("with {posture}, largest distance of the places of a surface "
                "that are compared; 0: the diagonal over 300")
          .AtLeast(0));
}

struct PostureOptions : PostureSettings {
  std::string out;  // folder for posture.json and the coloured mesh, or empty
  RepairOptions repair;
};

// Compares a muscle in a frame with a mesh of the same muscle that was
// segmented in that posture: distances of the surfaces, volumes and their
// overlap. Both meshes are repaired as those of scenes are, and must then be
// closed. Prints a table; with an output folder, also writes posture.json
// (docs/report.md) and, in a build with VTK, posture.vtp: the muscle with the
// distance of each vertex as "distance_mm". Returns 0. Throws InputError,
// before anything is written, for bad input.
int PostureCommand(const PostureOptions& options, std::ostream& screen);

}  // namespace musclewarp
