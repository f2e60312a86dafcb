// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program_text.h"

namespace musclewarp {

// Return true if the arguments of a program ask for help: for the short one
// with -h or --helpshort, for all of it with --help. What follows "--" is no
// flag.
bool AsksForShortHelp(int argc, char** argv);
bool AsksForHelp(int argc, char** argv);

// Prints what a program does, examples, and the flags that one needs.
// Precondition, here and below (CHECKed): `flags` has all of text.main_flags.
void PrintShortHelp(const ProgramText& text,
                    const std::vector<ProgramFlag>& flags,
                    std::ostream& out);

// Prints the same with all flags. Each is there once: those that one needs
// first, the others under the headings of their structs, in the order of
// `flags`. Flags of other libraries (glog, gflags) are left out, as users do
// not need them.
void PrintHelp(const ProgramText& text,
               const std::vector<ProgramFlag>& flags,
               std::ostream& out);

}  // namespace musclewarp
