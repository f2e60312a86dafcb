// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>

#include "musclewarp/exchange/tetrahedral_mesh.h"

namespace musclewarp {

// Adds the figures of the mesh of a frame to its record in export.json.
// `surface_points`: how many of its points are those of the surface.
void AddElementFigures(const TetrahedralMesh& mesh,
                       const ElementQuality& quality,
                       Eigen::Index surface_points,
                       nlohmann::ordered_json* record);

// Print the figures of frames as a table, after the label of the frame.
void PrintElementHeading(std::ostream& screen);
void PrintElementFigures(const nlohmann::ordered_json& record,
                         std::ostream& screen);

// Says how many angles of all frames are small, and where; nothing if none is.
void PrintSmallAngles(
    const std::map<std::string, nlohmann::ordered_json>& records,
    std::ostream& screen);

}  // namespace musclewarp
