// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns what names of one muscle have in common: its letters in lower case,
// without
//   - the side: "left" and "right" anywhere, "l" and "r" as the first or last
//     word;
//   - numbers of parts: digits at the end of words ("max1"), or in their place;
//   - signs between words, so that "tib_ant" and "tibant" are one;
//   - words that say no more than that it is a muscle or a part of one, such as
//     "m.", "musculus", "muscle", "belly", "head of".
// "peroneus" becomes "fibularis", "glutaeus" "gluteus". Empty if nothing is
// left.
std::string MuscleKey(const std::string& name);

}  // namespace musclewarp
