// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/scene_parts.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"

namespace musclewarp::phantom {
namespace {

Solid BallSolid() {
  Solid ball;
  ball.name = "ball";
  ball.field = Sphere({0, 0, 0}, 15);
  ball.box = {Eigen::Vector3d::Constant(-20), Eigen::Vector3d::Constant(20)};
  ball.cell = 3;
  return ball;
}

TEST(SceneParts, AMeshIsTheSameForTheSameSeed) {
  const PhantomMesh mesh = MeshOf(BallSolid(), 1);
  EXPECT_EQ(mesh.name, "ball");
  EXPECT_TRUE(CountDefects(mesh.surface).IsClean());
  EXPECT_EQ(MeshOf(BallSolid(), 1).surface.points, mesh.surface.points);
  const Points other = MeshOf(BallSolid(), 2).surface.points;
  EXPECT_FALSE(other.rows() == mesh.surface.points.rows() &&
               other == mesh.surface.points);
}

TEST(SceneParts, AMuscleIsNamedAfterItsMesh) {
  ActionLine line;
  line.name = "line";
  const SceneMuscle muscle = MuscleOf(MeshOf(BallSolid(), 1), {line});
  EXPECT_EQ(muscle.name, "ball");
  EXPECT_EQ(muscle.mesh_path, "ball.ply");
  ASSERT_EQ(muscle.lines.size(), 1u);
  EXPECT_EQ(muscle.lines[0].name, "line");
}

TEST(SceneParts, AnAttachmentHasPointsOfTheMeshThatWereAccepted) {
  const PhantomMesh mesh = MeshOf(BallSolid(), 1);
  const auto is_top = [](const Eigen::Vector3d& p) { return p.z() > 5; };
  const Attachment attachment = AttachmentTo("body", mesh, is_top, 6);
  EXPECT_EQ(attachment.body, "body");
  ASSERT_EQ(attachment.points.rows(), 6);
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(is_top(attachment.points.row(i)));
    EXPECT_EQ((mesh.surface.points.rowwise() - attachment.points.row(i))
                  .rowwise()
                  .norm()
                  .minCoeff(),
              0);
  }
}

TEST(ScenePartsDeathTest, AnAttachmentNeedsEnoughPoints) {
  const PhantomMesh mesh = MeshOf(BallSolid(), 1);
  const auto none = [](const Eigen::Vector3d&) { return false; };
  EXPECT_DEATH(AttachmentTo("body", mesh, none, 1), "Check failed");
}

TEST(SceneParts, TheMiddleIsOfTheLongestStretch) {
  const Field two = Union(Sphere({-30, 0, 0}, 5), Sphere({20, 0, 0}, 12), 0);
  // Stretches are found in steps of half a millimetre.
  EXPECT_NEAR(MiddleAlongX(two, 0, 0), 20, 0.5);
  EXPECT_NEAR(MiddleAlongX(Sphere({-30, 0, 0}, 5), 3, 2), -30, 0.5);
}

TEST(SceneParts, ARotationKeepsItsCentreAndFollowsTheRightHand) {
  const Eigen::Vector3d centre(10, 20, 30);
  const Eigen::Matrix4d turn =
      RotationAbout(centre, Eigen::Vector3d::UnitZ(), 90);
  const Eigen::Vector4d moved =
      turn * (centre + Eigen::Vector3d::UnitX()).homogeneous();
  EXPECT_EQ(turn * centre.homogeneous(), centre.homogeneous());
  EXPECT_EQ(moved.head<3>(), centre + Eigen::Vector3d::UnitY());
}

TEST(SceneParts, PointsOfALineMoveWithTheirBodies) {
  ActionLine line;
  line.bodies = {"ground", "arm", "arm"};
  line.rest.resize(3, 3);
  line.rest << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  Points expected = line.rest;
  expected.row(1) << 0, 1, 0;
  expected.row(2) << 0, 2, 0;
  EXPECT_EQ(
      MovedLine(line,
                {{"arm",
                  RotationAbout(
                      Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 90)}}),
      expected);
}

}  // namespace
}  // namespace musclewarp::phantom
