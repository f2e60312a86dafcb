// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns true if the name of a file is that of one of a pair: the header
// (.hdr) or the voxels (.img), compressed (.gz) or not, in upper or lower case.
bool IsNiftiPairFile(const std::string& path);

// Returns the path of the header of a pair, given either of its files. Throws
// InputError if one of them is missing, and for ANALYZE 7.5, whose header has
// the same size but does not distinguish left from right.
std::string CheckedNiftiHeader(const std::string& path);

// Throws InputError if the header of a file of NIfTI (.nii or .hdr, compressed
// or not) is damaged in its size, in its number of dimensions, which VTK takes
// for the length of a list without a check, or in the type of its voxels, which
// VTK searches for beyond the end of a list.
void CheckNiftiFields(const std::string& header);

}  // namespace musclewarp
