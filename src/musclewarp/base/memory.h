// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

constexpr double kBytesPerGib = 1024.0 * 1024 * 1024;

// Returns the bytes of memory that this process can still have: what the system
// calls available and, if it is less, what its control groups leave. Infinity
// where neither can be told.
double AvailableMemory();

// Returns the bytes that the control groups of this process leave it, as of a
// container or of a job on a cluster: the least of its own group and of those
// around it, of both versions; infinity without a limit. `root` is empty, or in
// tests a folder in place of "/".
double LeftInControlGroups(const std::string& root);

// Returns "0.734 GiB of memory".
std::string MemoryText(double bytes);

}  // namespace musclewarp
