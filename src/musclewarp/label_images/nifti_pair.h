// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// True if a file is one of a pair by its name: the header (.hdr) or the voxels
// (.img), packed (.gz) or not, in any case.
bool IsNiftiPairFile(const std::string& path);

// Returns the path of the header of a pair, given either of its files. Throws
// InputError if one of them is missing, and for ANALYZE 7.5, whose header has
// the same size: it does not say where left and right are.
std::string CheckedNiftiHeader(const std::string& path);

}  // namespace musclewarp
