// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace musclewarp {

// Writes a file so that it appears complete or not at all: `write` receives a
// path beside the target with the same extension, which is renamed to `path`
// when `write` returns and removed when it throws. Throws InputError if the
// folder cannot be written.
void WriteFileAtomically(const std::string& path,
                         const std::function<void(const std::string&)>& write);

// The same for text at hand.
void WriteTextAtomically(const std::string& path, const std::string& text);

// Writes a folder so that it appears complete or not at all: `write` fills a
// hidden folder beside the target, which then takes the place of `path`.
void WriteFolderAtomically(
    const std::string& path,
    const std::function<void(const std::string&)>& write);

// Removes from a folder what the functions above were writing when their
// program was killed.
void RemovePartialOutput(const std::string& dir);

}  // namespace musclewarp
