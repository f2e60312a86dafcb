// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Reads a whole file into memory and returns its bytes. Throws InputError if
// the file is missing, is not a regular file (reading a pipe could block for
// ever), is empty, or cannot be read to its end.
std::string ReadFile(const std::string& path);

}  // namespace musclewarp
