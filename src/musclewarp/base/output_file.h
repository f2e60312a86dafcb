// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace musclewarp {

// Output that appears complete or not at all. A program may be interrupted at
// any moment; whoever looks at its results afterwards, or resumes the run, must
// not find half a file. The functions below therefore write beside the target,
// under a hidden name with ".partial" in it, and rename at the end.

// Returns what keeps files from being written to the folder `dir`, which need
// not exist: its closest parent that exists, if that is no folder or must not
// be written. Returns an empty text if nothing does.
std::string ObstacleToWriting(const std::string& dir);

// Writes a file. `write` receives the temporary path, which has the extension
// of `path` (writers choose the format by it). The temporary file is renamed to
// `path` when `write` returns, and removed when it throws. Throws InputError if
// the folder cannot be written.
void WriteFileAtomically(const std::string& path,
                         const std::function<void(const std::string&)>& write);

// Writes `text` to a file in the same way. Throws InputError if the folder
// cannot be written or the disk is full.
void WriteTextAtomically(const std::string& path, const std::string& text);

// Writes a folder: `write` fills a temporary folder, which then replaces the
// folder at `path`, if there is one, with everything in it. Throws InputError
// if the parent folder cannot be written.
void WriteFolderAtomically(
    const std::string& path,
    const std::function<void(const std::string&)>& write);

// Removes a folder, if it is there, in the same way: it is hidden first, so
// that whoever looks never finds a part of it.
void RemoveFolderAtomically(const std::string& path);

// Removes the temporary files and folders that the functions above left in
// `dir` because their program was killed.
void RemovePartialOutput(const std::string& dir);

}  // namespace musclewarp
