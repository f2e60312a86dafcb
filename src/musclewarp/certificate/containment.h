// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/certificate/boxed_mesh.h"

namespace musclewarp {

// Returns true if a point is inside a closed mesh, which may be several closed
// surfaces that cross each other: its winding number is not zero. A segment
// from it to a point outside then leaves the mesh more or less often than it
// enters it, counted by exact predicates. A segment that meets an edge or a
// corner is replaced by another one. A point on the surface is not inside. If
// no segment decides, the point counts as inside, so that a certificate claims
// nothing that is not proved.
bool IsInsideClosed(const Eigen::RowVector3d& point, const BoxedMesh& mesh);

}  // namespace musclewarp
