// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/motion/certified_contact.h"
#include "musclewarp/motion/frame.h"

namespace musclewarp {

// What a frame with certified contact has to hold.
constexpr double kMaxVolumeError = 4e-4;      // |ratio - 1|
constexpr double kMaxFoldedShare = 1e-3;      // of the triangles of a muscle
constexpr double kDisplacementPerDepth = 2;   // of the depth without contact
constexpr double kDisplacementAllowance = 1;  // mm, beside that

// What a frame does not hold of it, a sentence each: triangles that cross (how
// many, where, how deep), vertices inside another mesh, volume,
// self-intersections (no more than at rest), folded triangles, displacement.
std::vector<std::string> Shortcomings(const PreparedScene& scene,
                                      const CertifiedContact& contact,
                                      const Frame& frame);

// Moves the muscles to pose `index` so that they cross neither bones nor each
// other: from `state`, that of the frame before, which becomes that of this
// one; or, without, from contact.rest.
Frame SolveCertifiedFrame(const PreparedScene& scene,
                          const CertifiedContact& contact,
                          int index,
                          const FrameOptions& options,
                          const GroupSolver& solver,
                          SceneMeshes* meshes,
                          SceneState* state = nullptr);

// What crosses in contact.rest.
SceneIntersections CertifiedRestIntersections(const PreparedScene& scene,
                                              const CertifiedContact& contact,
                                              SceneMeshes* meshes);

}  // namespace musclewarp
