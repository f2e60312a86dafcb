// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/figures/bone_findings.h"
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

// Counts what muscles have in common with what repair took from bones, by
// exact tests, so that a certificate holds for the bones as they were
// delivered: by bone, then by muscle. `delivered`: one for each bone of the
// scene. Exempt triangles do not count.
std::vector<DeliveredCrossing> CrossingsWithDelivered(
    const std::vector<NamedMesh>& muscles,
    const std::vector<DeliveredOnly>& delivered,
    const std::vector<ExemptArea>& exempt = {});

}  // namespace musclewarp
