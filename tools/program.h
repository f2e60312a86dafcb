// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace musclewarp {

// The exit codes of all programs.
constexpr int kExitUsable = 0;     // done, and the result is usable
constexpr int kExitNotUsable = 1;  // ran, but the result is not usable
constexpr int kExitBadInput = 2;   // bad input or flags, nothing written

// The body of every program's main. It parses the flags (gflags) and runs
// `command` with the arguments that are no flags, whose exit code it returns.
//
//   int main(int argc, char** argv) {
//     return musclewarp::RunProgram(argc, argv, "my-program FILE...", Command);
//   }
//
// For --help it prints `usage` and the program's own flags; `usage` is a line
// of synopsis and then what the program does. An InputError is printed as
// "<program>: <message>", and the exit code is 2, as it is for unknown flags
// and values of the wrong type.
int RunProgram(
    int argc,
    char** argv,
    const std::string& usage,
    const std::function<int(const std::vector<std::string>&)>& command);

// Throws InputError, naming --threads, unless `threads` is from 0 (all cores)
// to 1024: OpenMP ends the program if it cannot start as many threads as it was
// asked for.
void CheckThreads(int threads);

// Returns the flags among LengthsThatCanBeAskedFor() (length_options.h) that
// were given on the command line.
std::set<std::string> LengthsGiven();

// For programs that take flags only: throws InputError, naming the first
// argument, if there is one.
void RefuseArguments(const std::vector<std::string>& arguments);

}  // namespace musclewarp
