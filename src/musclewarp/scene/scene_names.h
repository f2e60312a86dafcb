// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Longest name of a muscle, bone or line, in bytes. File systems allow 255 for
// a file name; the rest is left to the extension and to the suffix that a file
// has while it is being written.
constexpr int kLongestName = 200;

// A name for a message: in quotes, with control characters as JSON escapes them
// ("a\nb", "\u0000"), and cut off with "..." after some 40 bytes.
std::string QuotedName(const std::string& name);

// Throws InputError if a name cannot be shown in a table or a report: one with
// a control character, such as a line break, a tab or NUL. `where` names the
// file, `what` the thing that has the name ("pose").
void CheckPrintable(const std::string& where,
                    const std::string& what,
                    const std::string& name);

// Throws InputError if a name cannot be a column of the tables of a run: one
// that is not printable, or is longer than kLongestName.
void CheckColumnName(const std::string& where,
                     const std::string& what,
                     const std::string& name);

// Throws InputError if a name cannot be the name of a file, to which an
// extension is added: one that cannot name a column either, that has a "/", or
// that begins with a dot (such files are hidden, and "." and ".." are folders)
// or begins or ends with a blank, which nobody sees.
void CheckFileName(const std::string& where,
                   const std::string& what,
                   const std::string& name);

}  // namespace musclewarp
