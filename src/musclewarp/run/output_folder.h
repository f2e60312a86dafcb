// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Throws InputError, naming {out}, if a folder cannot be written. Does not make
// the folder.
void CheckWritable(const std::string& dir);

// Makes a folder. Throws InputError, naming {out}, if that fails.
void MakeFolder(const std::string& dir);

}  // namespace musclewarp
