// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/exchange/searchable_scene.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kReach = 2, kTolerance = 0.2;

// A muscle 0.3 mm above a bone, both balls.
RecordedPose MuscleOnBone(int fineness) {
  RecordedPose pose;
  pose.muscles = {MovedBy(Icosphere(20, fineness), {0, 0, 40.3})};
  pose.bones = {Icosphere(20, fineness)};
  return pose;
}

const RecordedNames& Names() {
  static const RecordedNames names = {{"psoas"}, {"femur"}};
  return names;
}

double SmallestGap(const RecordedPose& pose) {
  const SearchableScene scene = SceneOf(Names(), pose);
  const SceneIntersections found = IntersectScene(scene.muscles, scene.bones);
  EXPECT_TRUE(found.IsClean());
  return found.SmallestGap().value_or(INFINITY);
}

double Coarsen(RecordedPose* pose) {
  BoneCoarsening coarsening(kReach);
  coarsening.AddPose(*pose);
  const double error = coarsening.Coarsen(kTolerance, *pose);
  coarsening.Apply(pose);
  return error;
}

TEST(BoneCoarsening, KeepsTheGapAndTheTolerance) {
  RecordedPose pose = MuscleOnBone(4);
  const double gap = SmallestGap(pose);
  const Eigen::Index before = pose.bones[0].triangles.rows();
  const double error = Coarsen(&pose);
  EXPECT_LT(pose.bones[0].triangles.rows(), 0.5 * before);
  EXPECT_LE(error, kTolerance);
  EXPECT_GT(error, 0);
  EXPECT_EQ(SmallestGap(pose), gap);
}

// Every pose keeps its gap, and all have the same bones.
TEST(BoneCoarsening, IsOneForAllPoses) {
  RecordedPose above = MuscleOnBone(4), beside = above;
  beside.muscles[0] = MovedBy(Icosphere(20, 4), {40.5, 0, 0});
  const double gap_above = SmallestGap(above), gap_beside = SmallestGap(beside);
  BoneCoarsening coarsening(kReach);
  coarsening.AddPose(above);
  coarsening.AddPose(beside);
  coarsening.Coarsen(kTolerance, beside);
  coarsening.Apply(&above);
  coarsening.Apply(&beside);
  EXPECT_EQ(above.bones[0].triangles, beside.bones[0].triangles);
  EXPECT_EQ(SmallestGap(above), gap_above);
  EXPECT_EQ(SmallestGap(beside), gap_beside);
}

TEST(BoneCoarsening, WithoutMusclesNearAllOfABoneIsCoarse) {
  RecordedPose near = MuscleOnBone(4), far = near;
  far.muscles[0].points.col(2).array() += 100;
  Coarsen(&near);
  Coarsen(&far);
  EXPECT_LT(far.bones[0].triangles.rows(), near.bones[0].triangles.rows());
}

TEST(RemeshMuscles, GivesTrianglesOfOneSizeThatCrossNothing) {
  RecordedPose pose = MuscleOnBone(4);
  const TriangleSoup before = pose.muscles[0];
  RecordedAttachments attachments;
  AttachedArea upper = {"pelvis", {}};
  for (int v = 0; v < before.points.rows(); ++v) {
    if (before.points(v, 2) > 50) upper.vertices.push_back(v);
  }
  attachments.muscles["psoas"] = {upper};
  constexpr double kSize = 5;
  const MuscleRemeshing result =
      RemeshMuscles(kSize, 1, Names(), &pose, &attachments);
  const TriangleSoup& after = pose.muscles[0];
  // Chords of 4/3 of the size on a ball of 20 mm leave it by s^2 / (8 r) / 3 at
  // the middle of a triangle, and what is separated moves a little more.
  EXPECT_LT(result.max_error, 0.7);
  EXPECT_TRUE(result.unchanged.empty());
  const double area = SurfaceArea(after.points, after.triangles);
  const double of_regular = std::sqrt(3.0) / 4 * kSize * kSize;
  EXPECT_NEAR(area / of_regular / after.triangles.rows(), 1, 0.4);
  EXPECT_GT(SmallestGap(pose), 0);
  // The area moves to the new vertices. One edge may go either way.
  const std::vector<int>& vertices = attachments.muscles["psoas"][0].vertices;
  EXPECT_GT(vertices.size(), 10u);
  for (const int v : vertices) EXPECT_GT(after.points(v, 2), 50 - kSize);
}

}  // namespace
}  // namespace musclewarp
