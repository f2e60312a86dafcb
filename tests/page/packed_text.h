// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Reads packed numbers on its own, as the header of PackedNumbers says: `text`
// is PackedNumbers::Base64(), `where` what Add returned.
std::vector<int> UnpackedNumbers(const std::string& text,
                                 const nlohmann::ordered_json& where);

// Returns the points of a pose (three to a row) of a packed motion, as the
// header of PackMotion says: `text` as above, `motion` its JSON.
Points UnpackedPose(const std::string& text,
                    const nlohmann::ordered_json& motion,
                    int pose);

// Returns the JSON of a page, from the script with the id.
nlohmann::json PageJson(const std::string& html, const std::string& id);

// Returns the text of a script of a page, by its id.
std::string ScriptText(const std::string& html, const std::string& id);

}  // namespace musclewarp
