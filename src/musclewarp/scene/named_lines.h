// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/poses_file.h"

namespace musclewarp {

// The lines that a muscle of a scene may name in place of their points.
struct NamedLines {
  PosesFile poses_file;
  const Model* model = nullptr;  // whose muscles are lines; null without one

  // Returns the names of all of them, for messages.
  std::vector<std::string> Names() const;
};

}  // namespace musclewarp
