// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "musclewarp/geometry/view.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/page/packed_numbers.h"

namespace musclewarp {

// What the pages have in common, as tools/report/src/data reads it.

// Returns a bundle of tools/report with its data filled in: JSON as the script
// with the id `data_id` (DeflatedBase64, so that no text in it can end the
// script), and packed numbers (PackedNumbers::Base64). Precondition (CHECKed):
// the bundle has a place for the data.
std::string PageText(std::string_view bundle,
                     const std::string& data_id,
                     const nlohmann::ordered_json& json,
                     const std::string& numbers);

// Returns the step to which positions are rounded, mm: 2^-17 of the diagonal of
// the box around all points, some micrometres.
double RoundingStep(const std::vector<const Points*>& points);

// Returns the surface of a bone, simplified for view to about `max_triangles`
// (Decimated), its numbers packed.
nlohmann::ordered_json BoneShapeJson(const std::string& name,
                                     const TriangleSoup& soup,
                                     double step,
                                     int max_triangles,
                                     PackedNumbers* packed);

nlohmann::ordered_json ViewJson(const View& view);

}  // namespace musclewarp
