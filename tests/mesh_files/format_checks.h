// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What the tests of the mesh formats have in common.

// A soup that is hard to keep: coordinates that need all 17 digits, the ends of
// the range of double, both zeros, a point no face uses, two equal points and a
// face without area.
TriangleSoup HardSoup();

// True if the soups are the same bit for bit: tells 0 from -0.
bool SameBits(const TriangleSoup& a, const TriangleSoup& b);

// The corners of all triangles in a row, with blanks.
std::string TextOf(const Triangles& triangles);

// TextOf the triangles of a square with the corners 0, 1, 2, 3.
constexpr char kTwoTriangles[] = "0 1 2 0 2 3";

// `text` with its first `old_part`, which must be there, replaced.
std::string With(std::string text,
                 const std::string& old_part,
                 const std::string& new_part);

}  // namespace musclewarp
