// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/fibres/continued_lines.h"
#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// What lies around the lines of a muscle at rest.
struct LineSurroundings {
  std::vector<BodySurface> bodies;

  // The muscle itself, and the soft parts through which its lines continue.
  std::vector<const TriangleBvh*> soft;

  // The ends of these on bones.
  std::vector<SoftPartEnd> ends;
};

// Finds what holds the sliding lines of a muscle where they are at rest, so
// that they are taut in other poses (taut_lines.h). At each bend something
// holds the line; the support doubles its push over 5 mm, and is gone 5 mm off.
// It is hard where the line bends round a bone that the muscle touches. Points
// are kept from coming nearer to the bone beside which the muscle lies, and
// held along the attachments. Lines with equally many points between the same
// bodies, which those of one muscle have if they were made, are tied to each
// other, as their muscle spans the space between them. Lines that do not slide
// stay as they are.
void FindSupports(const LineSurroundings& around,
                  std::vector<ActionLine>* lines);

}  // namespace musclewarp
