// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/crossing_triangles.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The view of a soup, which must outlive it.
inline SurfaceView ViewOf(const TriangleSoup& soup) {
  return {&soup.points, &soup.triangles};
}

// CrossingTriangles() of views of muscles and bones.
inline std::vector<CrossingPair> CrossingTriangles(
    const std::vector<SurfaceView>& muscles,
    const std::vector<SurfaceView>& bones) {
  std::vector<BoxedMesh> meshes;
  for (const SurfaceView& muscle : muscles) meshes.emplace_back(muscle);
  for (const SurfaceView& bone : bones) meshes.emplace_back(bone);
  return CrossingTriangles(meshes, muscles.size());
}

}  // namespace musclewarp
