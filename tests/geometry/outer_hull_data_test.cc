// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <string>

#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/data_root.h"

namespace musclewarp {

TEST(OuterHullData, MusclesAsDelivered) {
  const std::string root = DataRoot();
  if (root.empty()) GTEST_SKIP() << kNoDataRoot;
  for (const std::string path : {"lhdl_hip/gluteus_maximus_r.ply",
                                 "lhdl_hip/gluteus_medius_r.ply",
                                 "lhdl_hip/iliacus_r.ply",
                                 "lhdl_hip/psoas_major_r.ply",
                                 "bodyparts3d/raw/gluteus_medius.obj",
                                 "bodyparts3d/raw/semitendinosus.obj"}) {
    SCOPED_TRACE(path);
    const TriangleSoup fine = ReadTriangleSoup(root + "/" + path);
    for (const int count : {200, 600}) {
      OuterHullOptions options;
      options.coarse_vertices = count;
      const TriangleSoup hull = OuterHull(fine, options);
      EXPECT_NEAR(hull.points.rows(), count, 0.2 * count);
      EXPECT_TRUE(Encloses(hull, fine));
      EXPECT_TRUE(SelfIntersections(hull).empty());
      // The layer around the muscle has its area times the distance of the
      // hull. Curved ends, and grooves that the hull bridges, add to it.
      const double area = SurfaceArea(fine.points, fine.triangles);
      const double layer =
          area * std::max(options.relative_distance * std::sqrt(area),
                          2.0 / 15 * std::sqrt(2 * area / count));
      const double added = SignedVolume(hull.points, hull.triangles) -
                           SignedVolume(fine.points, fine.triangles);
      EXPECT_GT(added, 0.5 * layer);
      EXPECT_LT(added, 1.5 * layer);
    }
  }
}

}  // namespace musclewarp
