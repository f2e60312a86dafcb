// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Longest name of a muscle, bone or line, in bytes. File systems allow 255 for
// a file name; the difference leaves room for the extension and for the suffix
// of a file that is being written.
constexpr int kLongestName = 200;

// Returns a name for a message: in quotes, with control characters escaped as
// in JSON ("a\nb", "\u0000"), and cut off with "..." after about 40 bytes.
std::string QuotedName(const std::string& name);

// Returns a name as the tables of a run have it as a column: OpenSim splits
// labels at blanks, which become "_".
std::string ColumnName(std::string name);

// Throws InputError if a name cannot be shown in a table or a report because it
// has a character that breaks lines or that nobody sees: controls (U+0000 to
// U+001F, U+007F to U+009F), separators of lines (U+2028, U+2029), marks of
// direction, by which a name looks like another one (U+061C, U+200E, U+200F,
// U+202A to U+202E, U+2066 to U+2069), and characters without width (U+200B,
// U+2060 to U+2064, U+FEFF). Joiners (U+200C, U+200D) are allowed, as Persian
// and other scripts need them. `where` names the file, `what` the kind of
// object that has the name ("pose").
void CheckPrintable(const std::string& where,
                    const std::string& what,
                    const std::string& name);

// Throws InputError if a name cannot head a column in the tables of a run: if
// it is not printable, or is longer than kLongestName.
void CheckColumnName(const std::string& where,
                     const std::string& what,
                     const std::string& name);

// Throws InputError if a name, with an extension added, cannot be a file name:
// if it cannot head a column either, has a "/", begins with a dot (such files
// are hidden, and "." and ".." are folders), or begins or ends with a blank,
// which is easily overlooked.
void CheckFileName(const std::string& where,
                   const std::string& what,
                   const std::string& name);

}  // namespace musclewarp
