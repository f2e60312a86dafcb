// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// Data about the model that a run gives in addition to the scene file.
struct ModelSources {
  // The motion file, which replaces that of the scene; empty: the scene's own.
  std::string motion = {};

  // Folders that are searched for meshes of the model before those that the
  // scene names. They are relative to the working directory.
  std::vector<std::string> geometry = {};

  // Whether angles of the motion are in degrees, regardless of its header.
  std::optional<bool> motion_in_degrees = {};
};

}  // namespace musclewarp
