// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_repair/repair.h"

namespace musclewarp {

// Repairs a mesh with the default options, and expects that nothing is wrong
// with it any more.
inline TriangleSoup Repaired(const TriangleSoup& soup, RepairReport* report) {
  const TriangleSoup repaired =
      RepairMesh(soup, "muscle.ply", RepairOptions(), report);
  EXPECT_TRUE(CountDefects(repaired).IsClean());
  return repaired;
}

// mm^3
inline double Volume(const TriangleSoup& soup) {
  return SignedVolume(soup.points, soup.triangles);
}

}  // namespace musclewarp
