// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

// The triangles of a bone as it was delivered that its repaired mesh does not
// have, because the repair left them out, moved or replaced them. Together with
// the repaired mesh they hold every triangle that was delivered.
struct DeliveredOnly {
  std::string bone;
  TriangleSoup soup;  // in the pose of the muscles, mm
};

// What a muscle has in common with the triangles of a bone that only the
// delivered mesh has.
struct DeliveredCrossing {
  std::string muscle;
  std::string bone;
  int triangle_pairs = 0;

  // Pieces of the bone that lie within the muscle.
  int pieces_inside = 0;

  // The mean of the corners of the muscle's triangles that cross, or a point of
  // a piece inside if none do, mm.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

// Counts what muscles have in common with what repair took from bones, by
// exact tests, so that a certificate holds for the bones as they were
// delivered: by bone, then by muscle. `delivered`: one for each bone of the
// scene. Exempt triangles do not count.
std::vector<DeliveredCrossing> CrossingsWithDelivered(
    const std::vector<NamedMesh>& muscles,
    const std::vector<DeliveredOnly>& delivered,
    const std::vector<ExemptArea>& exempt = {});

}  // namespace musclewarp
