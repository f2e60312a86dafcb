// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

constexpr double kBytesPerGib = 1024.0 * 1024 * 1024;

// Returns the bytes of memory that this process can still have: what the system
// calls available and, if it is less, what the process's control group leaves
// (containers, jobs of a cluster). Infinity where neither can be told.
double AvailableMemory();

// Returns "about 0.7 GiB of memory".
std::string MemoryText(double bytes);

}  // namespace musclewarp
