// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace musclewarp {

// Reads packed numbers on its own, as the header of PackedNumbers says: `text`
// is PackedNumbers::Base64(), `where` what Add returned.
std::vector<int> UnpackedNumbers(const std::string& text,
                                 const nlohmann::ordered_json& where);

// Returns the text of a script of a page, by its id.
std::string ScriptText(const std::string& html, const std::string& id);

}  // namespace musclewarp
