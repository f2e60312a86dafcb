// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// Checks the field "pieces" of a muscle in a scene file, which selects the
// treatment of a mesh of several closed surfaces. The only allowed value is
// "largest": the largest surface is kept, and the others count as lost. Throws
// InputError for any other value; the message for "all" explains the
// alternative, as a muscle is one closed surface.
void CheckPieces(const JsonField& field);

}  // namespace musclewarp
