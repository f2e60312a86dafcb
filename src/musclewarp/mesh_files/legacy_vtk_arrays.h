// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {

// Arrays of a legacy VTK file that have to be passed over to find what comes
// behind them: field data, which may hold numbers, bits, texts and variants,
// and metadata.

// Returns the type of numbers that a legacy VTK file calls `name`, in any case.
// Throws InputError, with the place of the cursor, for other names.
ScalarType LegacyVtkScalarType(const TextCursor& cursor, std::string_view name);

// Throws InputError that says that a file is truncated: of `count` numbers or
// texts that `what` promises, not all are there.
[[noreturn]] void ThrowLegacyVtkTruncated(const TextCursor& cursor,
                                          const char* what,
                                          std::int64_t count);

// Passes over the values of an array in a section FIELD, `count` of the type
// called `type`. The cursor is behind the line that names the array. Throws
// InputError for an unknown type, for values that are not of their type, and if
// the file ends before the last.
void SkipLegacyVtkArray(std::string_view type,
                        std::int64_t count,
                        bool is_binary,
                        TextCursor* cursor);

// Passes over a section METADATA, which ends with an empty line; the cursor is
// behind its first line.
void SkipLegacyVtkMetadata(TextCursor* cursor);

}  // namespace musclewarp
