// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// What a run gives in addition to what a scene file says about its model.
struct ModelSources {
  // The motion in place of the one that the scene names; empty: that one.
  std::string motion = {};

  // Folders in which meshes of the model are looked for, before those of the
  // scene. They are relative to the working folder.
  std::vector<std::string> geometry = {};

  // Whether angles of the motion are in degrees, whatever its header says.
  std::optional<bool> motion_in_degrees = {};
};

}  // namespace musclewarp
