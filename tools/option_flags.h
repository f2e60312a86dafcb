// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "musclewarp/base/input_error.h"
#include "tools/deform_command.h"

namespace musclewarp {

// The flags that set fields of an options struct, by field:
// "OuterHullOptions::coarse_vertices" -> "coarse_vertices".
using FlagsOfFields = std::map<std::string, std::string>;

// Turns what the IsValid of an options struct says to users of the library,
// "OuterHullOptions::coarse_vertices is 5, allowed: 20 to 5000", into an error
// for users of a program: "--coarse_vertices: is 5; allowed: 20 to 5000". The
// message of a field without a flag stays as it is.
InputError FlagError(const std::string& message, const FlagsOfFields& flags);

// Throws InputError if the options of a run are not valid, naming the flag, its
// value and what is allowed. Nothing has to be read for that.
void CheckValid(const DeformOptions& options);

// The same for the options with which meshes are separated.
void CheckValid(const RestSeparationOptions& options);

// Sets the distance that certified contact keeps between surfaces, mm, and what
// follows from it. Throws InputError, naming --gap, if it is too large; that it
// is above 0 is left to CheckValid.
void SetGap(double gap, CertifiedContactOptions* options);

}  // namespace musclewarp
