// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// 3D Slicer writes into a mesh file in which space its coordinates are, as
// "SPACE=LPS" (+x left, +y back, +z head) or "SPACE=RAS" (+x right, +y front,
// +z head): in the header of .stl, in the title of .vtk, in comments of .ply
// and .obj, and as a text "SPACE" in the field data of .vtp and, in older
// versions, of .vtk. Meshes of one subject in both are turned against each
// other by half a turn.

// Returns "LPS" or "RAS" if the bytes of a mesh file with this extension (with
// its dot, in lower case) say so, or else "".
std::string StatedSpaceIn(const std::string& extension, std::string_view bytes);

// Returns the same of a mesh file (mesh_path.h), which is read for it; "" also
// if it cannot be read, of which its reader has to tell.
std::string StatedSpace(const std::string& path);

// A mesh file, or an image, and the space that it states, "" if none.
struct StatedFile {
  std::string file;
  std::string space;
};

// How files come into one space.
struct CommonSpace {
  std::string space;  // that of all files then; empty if none states one

  std::vector<bool> is_turned;  // by file: x and y have to change their signs
  std::vector<std::string> warnings;
};

// Returns what brings files into one space. If those that state one agree,
// nothing is turned. Otherwise those are that state another than `axes`, or
// than the first of them if `axes` is neither "LPS" nor "RAS". A warning names
// each of these, and those that state none and are taken as they are.
//
// `axes` is where +x, +y and +z point as something else than the files says,
// which `axes_place` names, or empty. A warning says so if all that is stated
// contradicts it.
CommonSpace FindCommonSpace(const std::vector<StatedFile>& files,
                            const std::string& axes = "",
                            const std::string& axes_place = "");

// Throws InputError if two files state different spaces.
void CheckOneSpace(const std::vector<StatedFile>& files);

// Takes points from LPS to RAS, or back: x and y change their signs.
void TurnToOtherSpace(Points* points);

}  // namespace musclewarp
