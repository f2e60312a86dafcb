// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/joints/articulation.h"

namespace musclewarp {

// What musclewarp-articulate is asked for beside its files; the fields are its
// flags.
struct ArticulateOptions {
  std::string out;  // folder for the results

  // Meshes of muscles, which the scene has beside the bones, and labels of an
  // image that are bones although neither the table nor their names say so.
  std::vector<std::string> muscles;
  std::vector<std::string> bones;

  // The table of the labels (label_table.h), and the length of the edges of
  // their surfaces, mm; 0: twice the edge of a voxel.
  std::string labels;
  double edge = 0;

  // "right", "left" or "both"; the names of joints, none: all; "anatomy" or
  // "scan"; see ArticulationOptions.
  std::string side = "both";
  std::vector<std::string> joints;
  std::string zero = "anatomy";
  std::string axes = "LPS";  // "none" if they are not known

  // A file of joints that replace those found (joints_file.h).
  std::string given;

  // Coordinates that move together: "hip_flexion_r:-10:60:15" goes from -10 to
  // 60 degrees in 15 frames. Without any there is a motion for each coordinate,
  // through its range, and the scene moves the first one by 30 degrees.
  std::vector<std::string> motion;

  // Of the mesh files, and of a label image that does not state its own.
  std::string units = "mm";
  int threads = 0;    // 0: as many as OpenMP chooses
  bool html = false;  // also write joints.html, a page to look at
};

// Returns the options of the library, with the joints of `options.given` read.
// Throws InputError that names the flag.
ArticulationOptions ArticulationOptionsOf(const ArticulateOptions& options);

// Finds the joints of a skeleton on its bones, and writes what
// musclewarp-deform needs to move it: out/model.osim with its meshes in
// out/Geometry, out/motions/<name>.mot, out/scene.json, which moves the muscles
// by the first motion, and out/joints.json, the report (docs/joints.md).
// Options.html adds out/joints.html, the page of the joints (joints_page.h).
//
// `files` are meshes of bones, whose names tell what they are (bone_names.h),
// and at most one label image, which has muscles, too (articulate_input.h); its
// meshes are written to out/meshes.
//
// Returns 0 if all joints are good or weak, and 1 if one failed. Throws
// InputError, before anything is written, for files that cannot be read, two
// meshes of one name, options that are not allowed, coordinates that no joint
// has, and for what Articulate throws.
int ArticulateCommand(const std::vector<std::string>& files,
                      const ArticulateOptions& options,
                      std::ostream& screen);

}  // namespace musclewarp
