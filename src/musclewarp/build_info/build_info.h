// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The version of the project, such as "0.2.0".
extern const char* const kVersion;

// 16 hexadecimal digits: a hash of all sources of the library and the programs
// (cmake/MusclewarpSources.cmake). It is the same for the same sources, also
// for those of a source package.
extern const char* const kSourcesHash;

// The compiler and the libraries on which results depend, with their versions:
// another version of CGAL wraps another hull.
extern const char* const kBuiltWith;

// Returns a text that differs between any two builds whose results may differ:
// results on disk are taken for current only if they were made by this code.
std::string CodeKey();

// Returns what --version prints behind the name of a program:
// "0.2.0 (sources 0123456789abcdef)".
std::string VersionText();

}  // namespace musclewarp
