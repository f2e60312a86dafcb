// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/measured_bone.h"

#include <utility>

#include "musclewarp/mesh/long_axis.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {

MeasuredBone Measured(Bone bone) {
  MeasuredBone measured;
  const TriangleSoup& mesh = bone.mesh;
  if (SurfaceArea(mesh.points, mesh.triangles) > 0) {
    measured.ends = LongAxis(mesh.points, mesh.triangles);
  }
  measured.bone = std::move(bone);
  return measured;
}

}  // namespace musclewarp
