// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {

// The settings of the export for finite elements.
struct ElementOptions {
  std::string mesher = "tetgen";  // see FindMesher
  double mesher_timeout_s = 600;
  double min_dihedral_deg = 0;
  double element_size = 0;
  bool bones = true;
  double bone_tolerance = 0.5;
  bool one_mesh = false;
  bool resume = false;
};

constexpr const char* HeadingOf(Described<ElementOptions>) {
  return "Finite elements";
}

constexpr auto FieldsOf(Described<ElementOptions>) {
  using S = ElementOptions;
  return std::make_tuple(
      Field(&S::mesher, "mesher")
          .Text("the program that makes tetrahedra: tetgen, gmsh, or the path "
                "of one"),
      Field(&S::mesher_timeout_s, "mesher_timeout_s", "s")
          .Text("a frame that takes longer fails")
          .Above(0),
      Field(&S::min_dihedral_deg, "min_dihedral_deg", "degrees")
          .Text("frames with a smaller angle between faces fail; that of a "
                "regular tetrahedron is 70.5")
          .Within(0, 70),
      Field(&S::element_size, "element_size", "mm")
          .Text("edges of the tetrahedra, for which muscles get new triangles; "
                "0: the triangles of the run stay, bit for bit, and set the "
                "size")
          .AtLeast(0),
      Field(&S::bones, "bones")
          .Text("bones as rigid surfaces beside the tetrahedra"),
      Field(&S::bone_tolerance, "bone_tolerance", "mm")
          .Text("bones are simplified by at most so much, times body_size, "
                "only where they are more than 2 mm and this away from all "
                "muscles; 0: they stay")
          .AtLeast(0),
      Field(&S::one_mesh, "one_mesh")
          .Text("the tetrahedra of the first frame, moved to the others"),
      Field(&S::resume, "resume")
          .Text("keep the tetrahedra of frames that are there from a run with "
                "the same flags"));
}

// Returns the formats for finite elements in this build.
const std::vector<std::string>& ElementFormats();

// Writes frames of a run, given by their indices in run.frames, as meshes of
// tetrahedra to DIR/frame_0000.<format>, and the outcome of each to
// DIR/export.json. A frame fails, and has no file, if its meshes cross, the
// mesher makes no mesh, or the quality of the mesh is not as required. Returns
// an exit code: kExitNotUsable if a frame failed. Throws InputError, before
// anything is written, for bad options.
int ExportElements(const RunOutline& run,
                   const std::vector<int>& frames,
                   const std::vector<std::string>& formats,
                   const ElementOptions& options,
                   const std::string& dir,
                   std::ostream& screen);

}  // namespace musclewarp
