// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Paths in files that are moved, copied and mailed: they lead from the folder
// of the file, and what is shown to others names no folders of the machine.

// Returns the path of a file or folder from `folder` on, with "/" between its
// parts; "." for `folder` itself. `path` is absolute or from the working folder
// on. Returns it as it is if nothing is there.
std::string PathFrom(const std::string& folder, const std::string& path);

// Replaces every path in a text, such as a warning or a command line, at which
// something is, by the path from `folder` on. Paths are absolute or from the
// working folder on, with a "/" in them.
std::string WithPathsFrom(const std::string& folder, const std::string& text);

// Replaces every path in a text that is absolute or leaves its folder ("../")
// by its last part. A path ends at a blank, a quotation mark, a comma, a colon,
// a semicolon or a bracket.
std::string WithoutFolders(const std::string& text);

}  // namespace musclewarp
