// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/reconstruction_loss.h"

#include <gtest/gtest.h>

#include <vector>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/pieces.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Of places of 100 mm, and of sums over triangles.
constexpr double kRoundingOfPlaces = 1e-9;

// A belly along z from 0 to 100 mm with a tendon of 3 mm beyond it, to 160 mm.
TriangleSoup Belly() { return MovedBy(Spindle(15, 50, 3), {0, 0, 50}); }
TriangleSoup Tendon() { return MovedBy(Spindle(1.5, 40, 3), {0, 0, 120}); }

PreparedMuscle Prepared(const TriangleSoup& mesh,
                        const std::vector<std::string>& carriers) {
  PreparedMuscle muscle;
  muscle.model.name = "psoas";
  muscle.model.fine_rest = mesh.points;
  muscle.model.fine_triangles = mesh.triangles;
  muscle.model.rest_volume = SignedVolume(mesh.points, mesh.triangles);
  for (const std::string& carrier : carriers) {
    muscle.attached.vertices.push_back(
        static_cast<int>(muscle.model.attachments.size()));
    muscle.attached.attachment.push_back(
        static_cast<int>(muscle.model.attachments.size()));
    Attachment attachment;
    attachment.body = carrier;
    muscle.model.attachments.push_back(attachment);
  }
  return muscle;
}

DeliveredMuscle Delivered(double depth) {
  return {Together(Belly(), Tendon()), {"femur", "pelvis"}, depth};
}

TEST(LossOf, ATendonThatIsGoneIsToldByAreaExtentAndAttachment) {
  const SurfaceReconstruction loss =
      LossOf(Delivered(0), Prepared(Belly(), {"pelvis"}));
  // The belly reaches to 100 mm, the tendon to 160.
  EXPECT_NEAR(loss.lost_extent, 60, 0.1);
  const double tendon = SurfaceArea(Tendon().points, Tendon().triangles);
  EXPECT_GT(loss.gone_area, 0.6 * tendon);
  EXPECT_LT(loss.gone_area, tendon);
  EXPECT_NEAR(loss.farthest, 60, 1);
  EXPECT_EQ(loss.lost_attachments, std::vector<std::string>{"femur"});
}

TEST(LossOf, NothingIsGoneOfTheSameMesh) {
  const SurfaceReconstruction loss = LossOf(
      Delivered(0), Prepared(Together(Belly(), Tendon()), {"pelvis", "femur"}));
  EXPECT_EQ(loss.gone_area, 0);
  EXPECT_EQ(loss.lost_extent, 0);
  EXPECT_TRUE(loss.lost_attachments.empty());
}

// What lies beyond a bone has to come back by about the depth.
TEST(LossOf, TwiceTheDepthInOthersIsNotGone) {
  const PreparedMuscle belly = Prepared(Belly(), {"pelvis", "femur"});
  EXPECT_EQ(LossOf(Delivered(30), belly).gone_area, 0);
  EXPECT_GT(LossOf(Delivered(20), belly).gone_area, 0);
  EXPECT_NEAR(LossOf(Delivered(20), belly).lost_extent, 60 - 40, 0.1);
}

// Half of the triangles of a thin plate begin with an edge of 10 mm, half with
// a diagonal of 14.1 mm.
TEST(LossOf, SurfaceFartherThanAnEdgeIsLost) {
  constexpr double kThickness = 0.1, kSide = 30;
  DeliveredMuscle delivered;
  delivered.mesh = LatticeBox(3, 3, 1);
  delivered.mesh.points.leftCols<2>() *= 10;
  delivered.mesh.points.col(2) *= kThickness;
  const auto lost_at = [&](double distance) {
    TriangleSoup moved = delivered.mesh;
    moved.points.col(2).array() += distance;
    return LossOf(delivered, Prepared(moved, {}));
  };
  const double around = 4 * kSide * kThickness, plate = 2 * kSide * kSide;
  EXPECT_LE(lost_at(9).lost_area, around);
  EXPECT_NEAR(lost_at(12).lost_area, plate / 2, around);
  const SurfaceReconstruction all = lost_at(15);
  EXPECT_NEAR(all.lost_area, plate + around, kRoundingOfPlaces);
  EXPECT_LT((all.place - Eigen::RowVector3d(15, 15, kThickness / 2)).norm(),
            kRoundingOfPlaces);
  EXPECT_NEAR(all.farthest, 15, kRoundingOfPlaces);
}

// Beyond 3 mm, and twice the depth: here that of the upper and the lower side.
TEST(LossOf, SurfaceFartherThanThreeMillimetresIsGone) {
  DeliveredMuscle delivered;
  delivered.mesh = Box(30, 30, 30);
  const auto gone_at = [&](double distance) {
    TriangleSoup moved = delivered.mesh;
    moved.points.col(2).array() += distance;
    return LossOf(delivered, Prepared(moved, {})).gone_area;
  };
  EXPECT_EQ(gone_at(2.9), 0);
  EXPECT_NEAR(gone_at(3.1), 2 * 30 * 30, kRoundingOfPlaces);
  delivered.depth = 1;
  EXPECT_EQ(gone_at(4.9), 0);
  EXPECT_NEAR(gone_at(5.1), 2 * 30 * 30, kRoundingOfPlaces);
}

TEST(LossOf, KnowsTheVolumesBeforeAndAfter) {
  const SurfaceReconstruction loss =
      LossOf(Delivered(0), Prepared(Belly(), {"pelvis"}));
  EXPECT_TRUE(loss.is_done);
  const auto volume = [](const TriangleSoup& mesh) {
    return SignedVolume(mesh.points, mesh.triangles);
  };
  EXPECT_NEAR(loss.volume_after, volume(Belly()), kRoundingOfPlaces);
  EXPECT_NEAR(loss.volume_before - loss.volume_after, volume(Tendon()), 1e-6);
}

// The deepest centre of a triangle, in the bone or in the other muscle.
TEST(DeliveredMuscleOf, KnowsHowDeepItIsInOthers) {
  const auto depth_with = [](double bone_from, double muscle_from) {
    PreparedScene scene;
    // Cubes of 10 mm with a lattice of 1 mm; those beside it begin at x.
    const TriangleSoup cube = LatticeBox(10, 10, 10);
    const auto add_muscle = [&](const TriangleSoup& mesh) {
      scene.muscles.push_back(Prepared(mesh, {"femur"}));
    };
    add_muscle(cube);
    add_muscle(MovedBy(LatticeBox(10, 20, 20), {muscle_from, -5, -5}));
    PreparedBone& bone = scene.bones.emplace_back();
    bone.mesh.name = "bone";
    bone.rest = MovedBy(LatticeBox(10, 20, 20), {-bone_from, -5, -5});
    const SceneMeshes meshes(scene);
    const DeliveredMuscle delivered = DeliveredMuscleOf(scene, meshes, 0);
    EXPECT_EQ(delivered.mesh.points, cube.points);
    EXPECT_EQ(delivered.carriers, std::set<std::string>{"femur"});
    return delivered.depth;
  };
  EXPECT_EQ(depth_with(11, 11), 0);
  EXPECT_NEAR(depth_with(11, 7), 3, kRoundingOfPlaces);
  EXPECT_NEAR(depth_with(8, 9), 2, kRoundingOfPlaces);
  EXPECT_NEAR(depth_with(8, 6), 4, kRoundingOfPlaces);
}

TEST(LostExtent, FollowsABentLine) {
  Points line(3, 3);
  line << 0, 0, 0, 50, 0, 0, 50, 50, 0;
  Points before(3, 3), after(3, 3);
  before << -5, 0, 0, 50, 0, 0, 50, 60, 0;
  after << -5, 0, 0, 50, 0, 0, 50, 45, 0;
  EXPECT_DOUBLE_EQ(LostExtent(before, after, line), 15);
  after.row(0) << 20, 3, 0;
  EXPECT_DOUBLE_EQ(LostExtent(before, after, line), 25);
}

TEST(LostExtent, WithoutALineIsAlongTheLongestAxisWhereverItPoints) {
  const Points before = Spindle(5, 50, 3).points;
  const Points after = 0.8 * before;
  // The farthest vertices are the tips.
  EXPECT_NEAR(LostExtent(before, after, {}), 10, 0.1);
  const Points turned = before.rowwise().reverse();
  EXPECT_NEAR(LostExtent(turned, 0.8 * turned, {}), 10, 0.1);
}

}  // namespace
}  // namespace musclewarp
