// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/path_functions/path_function.h"

namespace musclewarp {

// Returns the text of an OpenSim model with the paths of muscles replaced by
// functions: <GeometryPath> becomes <path><FunctionBasedPath>, as OpenSim 4.5
// has it, in m. The text is UTF-8, and its declaration names no other encoding;
// `bytes` may be in those of DecodeXml. Of a model in UTF-8 all other bytes
// stay as they are, also the line endings and the version of the document.
// `coordinates` are the names to which PathFunction::coordinates refers, and
// `where` names the file in messages. OpenSim has no linear continuation beyond
// the range of a function.
//
// Throws InputError if the text is not XML, or lacks a muscle with a
// <GeometryPath>, or a coordinate in a joint.
std::string WithFunctionPaths(const std::string& bytes,
                              const std::string& where,
                              const std::vector<std::string>& coordinates,
                              const std::map<std::string, PathFunction>& paths);

}  // namespace musclewarp
