// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace musclewarp {

// Returns the first `most` bytes of a file, or all if it has fewer,
// decompressed if the content is gzip data, regardless of the file name. Throws
// InputError if the file is missing or empty, or if its gzip data are damaged.
std::string ReadUnpacked(const std::string& path, std::uint64_t most);

}  // namespace musclewarp
