// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

struct MeshSize {
  std::string name;
  double diagonal;  // of its bounding box, mm
};

// Returns a sentence for each pair of meshes whose sizes differ by more than
// the factor `ratio`. This detects mixed units: a mesh in metres among others
// in millimetres is a thousand times too small.
std::vector<std::string> ScaleWarnings(const std::vector<MeshSize>& sizes,
                                       double ratio);

}  // namespace musclewarp
