// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// An action line of which an end does not stay where it is attached.
struct LeavingLine {
  std::string line;
  std::string pose;     // in which the end is farthest from its place
  double distance = 0;  // there, mm
};

// Returns the line that ends nearest to an attachment, if a pose takes its end
// away from where the body of the attachment would have it, by more than 2 mm.
// Such a line and the attachment contradict each other.
std::optional<LeavingLine> FindLeavingLine(const std::vector<ActionLine>& lines,
                                           const Attachment& attachment,
                                           const std::vector<ScenePose>& poses);

}  // namespace musclewarp
