// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/label_images/label_table.h"

namespace musclewarp {

// Returns what the name and the columns of a row of a table say of a bone.
// Throws InputError that names the table and the column for a kind of bone or a
// side that is not known.
NamedBone DescribedBone(const LabelEntry& entry, const std::string& table);

}  // namespace musclewarp
