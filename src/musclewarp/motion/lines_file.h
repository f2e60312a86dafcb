// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Beside the meshes of a frame.
constexpr char kLinesFile[] = "lines.json";

struct NamedLine {
  std::string name;
  Points points;  // #P x 3, mm, from origin to insertion
};

// What a muscle carries along.
struct MuscleLines {
  std::string name;  // of the muscle
  std::vector<NamedLine> lines;
  std::vector<Points> fibres;  // #P x 3 each, mm
};

// JSON: { "units": "mm", "muscles": [ { "name", "lines": [ { "name", "points":
// [[x, y, z], ...] } ], "fibres": [ [[x, y, z], ...] ] } ] }, to the last bit.
void WriteLinesFile(const std::string& path,
                    const std::vector<MuscleLines>& muscles);

// Throws InputError that names the file and the field.
std::vector<MuscleLines> ReadLinesFile(const std::string& path);

}  // namespace musclewarp
