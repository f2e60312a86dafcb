// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Throw InputError, with the flag that was probably meant, for the first
// argument, or line of a file of flags, that looks like a flag and is none of
// this program or of gflags. gflags refuses it, too, but does not say what is
// near. Of a file that cannot be read nothing is checked. `path` is that of
// --flagfile, several with commas.
void CheckNamesOfFlags(const std::vector<std::string>& arguments);
void CheckFlagsInFiles(const std::string& path);

}  // namespace musclewarp
