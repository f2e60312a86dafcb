// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/plane_section.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns `count` planes at right angles to a polyline (#P x 3, mm), in the
// middle of as many equal parts of its length. The direction of the line at a
// place is that of the chord over a tenth of its length around it, so that
// corners do not tilt planes suddenly; places where the line goes back upon
// itself have no plane. Preconditions (CHECKed): count is above 0; the line has
// at least two points and a length above 0.
SectionPlanes PlanesAcross(const Points& line, int count);

}  // namespace musclewarp
