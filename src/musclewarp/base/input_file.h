// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The bytes of a file. Throws InputError if it is missing, not a regular file
// (a pipe could block for ever), empty, or cannot be read to its end.
std::string ReadFile(const std::string& path);

}  // namespace musclewarp
