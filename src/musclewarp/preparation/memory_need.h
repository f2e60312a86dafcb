// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// A mesh of a scene, by what its memory depends on.
struct SizedMesh {
  std::string name;
  double vertices = 0;
  bool is_muscle = false;
};

// Returns the memory, bytes, that a run holds at most at a time, as measured on
// muscles and bones of up to a million vertices (docs/limits.md): the
// preparation and a frame at a time, without what the report keeps of frames,
// some 20 kB for each and each muscle. `coarse_vertices` is the size of the
// hull of a muscle.
double MemoryNeeded(const std::vector<SizedMesh>& meshes,
                    int coarse_vertices,
                    bool is_certified);

// Throws InputError, which names --max_memory_gib and the largest mesh, if a
// run needs more bytes than are allowed.
void CheckMemory(const std::vector<SizedMesh>& meshes,
                 double needed,
                 double allowed);

// Returns the memory that a scene needs with these muscles (by their repaired
// meshes) and its bones, before it is allocated. Throws as CheckMemory does.
double CheckedMemory(const PrepareOptions& options,
                     const std::vector<TriangleSoup>& muscles,
                     const PreparedScene& scene);

}  // namespace musclewarp
