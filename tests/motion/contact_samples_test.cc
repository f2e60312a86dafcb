// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/contact_samples.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(ContactSamples, AreAtTheSamePlacesOnAFinerMesh) {
  // Icospheres have edges of about 1.2 times the radius over 2^levels.
  const TriangleSoup hull = Icosphere(12, 1);
  const Points coarse = Icosphere(10, 3).points;
  const Points fine = Icosphere(10, 4).points;
  const std::vector<int> on_coarse = ContactSamples(coarse, hull, 100);
  const std::vector<int> on_fine = ContactSamples(fine, hull, 100);
  EXPECT_EQ(on_fine.size(), 100u);
  const double edge = 1.2 * 10 / 8;
  for (const int v : on_coarse) {
    const double nearest = (fine(on_fine, Eigen::all).rowwise() - coarse.row(v))
                               .rowwise()
                               .norm()
                               .minCoeff();
    EXPECT_LT(nearest, edge);
  }
}

TEST(ContactSamples, CoverTheSurfaceEvenly) {
  const Points fine = Icosphere(10, 4).points;
  const std::vector<int> samples = ContactSamples(fine, Icosphere(12, 1), 100);
  // A hundred discs that cover a sphere of radius 10 evenly have a radius of
  // at least 2; farthest points leave no place uncovered by twice as much.
  for (const Eigen::RowVector3d point : fine.rowwise()) {
    EXPECT_LT((fine(samples, Eigen::all).rowwise() - point)
                  .rowwise()
                  .norm()
                  .minCoeff(),
              4);
  }
}

TEST(ContactSamples, TakeEachVertexOnce) {
  const Points fine = UnitTetrahedron().points;
  EXPECT_EQ(ContactSamples(fine, Box(3, 3, 3), 50),
            (std::vector<int>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace musclewarp
