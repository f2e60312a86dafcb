// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace musclewarp {

// Returns the table of path functions of a page: what the page shows of a
// fit.json as musclewarp-export writes it (docs/export.md). Throws InputError
// that names the file and the field if it is no such file.
nlohmann::ordered_json PathTableOf(const std::string& file);

}  // namespace musclewarp
