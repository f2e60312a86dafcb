// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// Checks "pieces" of a muscle in a scene file, which says what becomes of a
// mesh of several closed surfaces. Allowed is "largest": it is kept, and the
// others count as lost. Throws InputError for anything else; for "all" it says
// what to do instead, as a muscle is one closed surface.
void CheckPieces(const JsonField& field);

}  // namespace musclewarp
