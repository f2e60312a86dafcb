// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace musclewarp {

// Paths in report.json and its like: values and texts under the keys that may
// hold some ("mesh", "model", "command", "warnings", ...). Names of muscles,
// poses and so on stay as they are, whatever is in them.

// Adapts the texts of a file in `folder`: all paths lead from that folder, and
// settings are named by their flags (base/setting_names.h).
void AdaptTexts(const std::string& folder, nlohmann::ordered_json* json);

// Leaves only the last part of each path that leads out of that folder, for a
// page that is mailed.
void RemoveFolders(nlohmann::ordered_json* json);

}  // namespace musclewarp
