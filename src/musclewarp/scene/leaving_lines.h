// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// An action line whose end moves away from its attachment.
struct LeavingLine {
  std::string line;
  std::string pose;     // the pose with the largest distance
  double distance = 0;  // of the end from its attached position, mm
};

// Returns the line that ends nearest to an attachment if, in some pose, its end
// is more than 2 mm from where the body of the attachment would carry it. Such
// a line contradicts the attachment. Points of `lines`, `attachment` and
// `poses` are in mm.
std::optional<LeavingLine> FindLeavingLine(const std::vector<ActionLine>& lines,
                                           const Attachment& attachment,
                                           const std::vector<ScenePose>& poses);

}  // namespace musclewarp
