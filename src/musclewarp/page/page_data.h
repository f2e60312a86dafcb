// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/page/recorded_run.h"

namespace musclewarp {

struct PageOptions {
  // Bones are shown with at most about so many triangles each.
  int max_bone_triangles = 6000;
  // How the axes of the meshes lie in the body, and the side of it that
  // "lateral" is on (see ParseView); empty: as the scene of the first run says.
  std::string axes;
  std::string side;
};

// What the page shows, in two parts (tools/report/src/data.ts reads them):
// texts and figures as JSON, positions and indices as packed numbers the JSON
// refers to. Positions are rounded to a 2^17th of the scene, some micrometres.
struct PageData {
  nlohmann::ordered_json json;
  std::string numbers;  // base64
};

// Throws InputError that names --axes or --side. Precondition: there is a run.
PageData PageDataOf(const std::vector<RecordedRun>& runs,
                    const PageOptions& options);

}  // namespace musclewarp
