// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns true if a mesh that is called `name` is the bone, or the group of
// bones, that a table calls `bone`: "calcn_r" is the "calcaneus", "First
// metatarsal bone, right" is "metatarsal_1", "metatarsals" are "metatarsal",
// and "metatarsal_1" is not. Sides do not count.
bool NamesBone(const std::string& name, const std::string& bone);

}  // namespace musclewarp
