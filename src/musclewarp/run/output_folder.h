// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Throws InputError, naming {out}, if a folder cannot be written. Does not make
// the folder.
void CheckWritable(const std::string& dir);

// Makes a folder. Throws InputError, naming {out}, if that fails.
void MakeFolder(const std::string& dir);

// Throws InputError, naming the setting "out", if one of the files that were
// read is DIR/<name> for one of the names: results would replace it. Files may
// name a part of a file (mesh_path.h).
void CheckInputsStay(const std::vector<std::string>& files,
                     const std::string& dir,
                     const std::vector<std::string>& names);

}  // namespace musclewarp
