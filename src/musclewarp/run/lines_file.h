// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The file of lines beside the meshes of a frame.
constexpr char kLinesFile[] = "lines.json";

// An action line where a muscle carries it.
struct NamedLine {
  std::string name;
  Points points;  // #P x 3, mm, from origin to insertion
};

// The action lines and fibres that a muscle carries.
struct MuscleLines {
  std::string name;  // of the muscle
  std::vector<NamedLine> lines;
  std::vector<Points> fibres;  // #P x 3 each, mm

  // Where its lines go on along tendons that have no mesh, #P x 3 each, mm.
  std::vector<Points> tendons = {};
};

// Writes a lines file, to the last bit:
//
//   { "units": "mm", "muscles": [ { "name", "lines": [ { "name", "points":
//   [[x, y, z], ...] } ], "fibres": [ [[x, y, z], ...] ] } ] }
//
// A muscle with tendons has them under "tendons", as fibres.
void WriteLinesFile(const std::string& path,
                    const std::vector<MuscleLines>& muscles);

// Reads a lines file. Throws InputError that names the file and the field.
std::vector<MuscleLines> ReadLinesFile(const std::string& path);

}  // namespace musclewarp
