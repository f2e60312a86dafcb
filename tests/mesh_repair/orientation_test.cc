// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/orientation.h"

#include <gtest/gtest.h>

#include "mesh_repair/battered_meshes.h"
#include "musclewarp/mesh/defects.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Reverses triangle f so that its first corner stays first.
void Reverse(int f, Triangles* triangles) {
  std::swap((*triangles)(f, 1), (*triangles)(f, 2));
}

void ReverseAll(Triangles* triangles) {
  triangles->col(1).swap(triangles->col(2));
}

// A bowl: an open part of a sphere.
TriangleSoup Bowl() {
  TriangleSoup soup = Icosphere(10, 2);
  CutOff(6, &soup);
  return soup;
}

TEST(OrientConsistently, LeavesAConsistentMeshAlone) {
  for (const TriangleSoup& mesh : {Icosphere(10, 2), Bowl()}) {
    TriangleSoup soup = mesh;
    const Flips flips = OrientConsistently(&soup);
    EXPECT_EQ(flips.flipped, 0);
    EXPECT_EQ(flips.conflicts, 0);
    EXPECT_EQ(soup.triangles, mesh.triangles);
  }
}

TEST(OrientConsistently, TurnsTheMinorityOfABowl) {
  TriangleSoup soup = Bowl();
  for (const int f : {0, 7, 8, 100}) Reverse(f, &soup.triangles);
  EXPECT_EQ(OrientConsistently(&soup).flipped, 4);
  EXPECT_EQ(soup.triangles, Bowl().triangles);
}

TEST(OrientConsistently, ABowlMayFaceEitherWay) {
  TriangleSoup soup = Bowl();
  ReverseAll(&soup.triangles);
  EXPECT_EQ(OrientConsistently(&soup).flipped, 0);
}

TEST(OrientConsistently, AClosedBodyFacesOutward) {
  TriangleSoup soup = Icosphere(10, 2);
  const Triangles outward = soup.triangles;
  ReverseAll(&soup.triangles);
  Reverse(5, &soup.triangles);  // faces outward by itself
  EXPECT_EQ(OrientConsistently(&soup).flipped, outward.rows() - 1);
  EXPECT_EQ(soup.triangles, outward);
}

TEST(OrientConsistently, DecidesForEachBodyAlone) {
  TriangleSoup soup = Icosphere(10, 1);
  TriangleSoup other = MovedBy(Icosphere(10, 1), {30, 0, 0});
  AddSoup(other, &soup);
  const Triangles outward = soup.triangles;
  for (int f = 80; f < 160; ++f) Reverse(f, &soup.triangles);
  EXPECT_EQ(OrientConsistently(&soup).flipped, 80);
  EXPECT_EQ(soup.triangles, outward);
}

TEST(OrientConsistently, AOneSidedSurfaceIsAConflictWithAPlace) {
  TriangleSoup soup = MoebiusStrip();
  const Flips flips = OrientConsistently(&soup);
  EXPECT_GT(flips.conflicts, 0);
  // The strip is 2 mm wide around a circle of radius 10 mm.
  EXPECT_NEAR(flips.conflict.head<2>().norm(), 10, 1.5);
  EXPECT_LE(std::abs(flips.conflict.z()), 1);
}

}  // namespace
}  // namespace musclewarp
