// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/own_region.h"
#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

struct InitialSeparationOptions {
  OwnRegionOptions region;
  double step = 0.3;  // of a vertex of a crossing triangle in a round, mm
  int max_rounds = 400;
};

struct InitialSeparation {
  std::vector<Points> points;  // by muscle, #V x 3
  int rounds = 0;
  int crossing_pairs = 0;  // left
};

// Parts meshes that overlap as the data come: a state in which no triangles of
// two muscles, or of a muscle and a bone, cross, to be relaxed from there
// (Relax). Vertices go into their muscle's own region; triangles that still
// cross, as their corners do not know of what pokes through between them, go
// further in, in small steps. What is exempt stays where it is.
InitialSeparation SeparateInitially(
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    const std::vector<ExemptArea>& exempt,
    const InitialSeparationOptions& options);

}  // namespace musclewarp
