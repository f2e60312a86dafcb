// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace musclewarp {

// RFC 4648, with padding, in one line.
std::string EncodeBase64(std::string_view bytes);

}  // namespace musclewarp
