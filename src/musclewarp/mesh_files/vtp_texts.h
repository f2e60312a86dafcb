// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace musclewarp {

// Returns the first text of the array of texts `name` in the field data of XML
// polydata (.vtp), whatever way it is written; `bytes` is the whole file.
// Returns "" if there is none, or if it is damaged. Only in builds with
// MUSCLEWARP_WITH_VTK.
std::string VtpFieldText(std::string_view bytes, std::string_view name);

}  // namespace musclewarp
