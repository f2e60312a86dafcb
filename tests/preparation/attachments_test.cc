// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/attachments.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

// Points a millimetre apart on the z axis; the lower ones belong to the pelvis,
// the upper ones to the femur, and 3 to both.
struct Line {
  Points rest = Points::Zero(8, 3);
  std::vector<Attachment> attachments;

  Line() {
    for (int i = 0; i < 8; ++i) rest(i, 2) = i;
    for (const double middle : {1.5, 5.0}) {
      Attachment attachment;
      attachment.body = middle < 3 ? "pelvis" : "femur";
      attachment.points = Eigen::RowVector3d(0, 0, middle);
      attachment.radius = 2.1;
      attachments.push_back(attachment);
    }
  }
  AttachedVertices Attached() const {
    return FindAttachedVertices(attachments, rest);
  }
  Points AttachedRest() const { return rest(Attached().vertices, Eigen::all); }
};

TEST(FindAttachedVertices, ListsEveryVertexOnceForTheFirstArea) {
  const AttachedVertices attached = Line().Attached();
  EXPECT_EQ(attached.vertices, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(attached.attachment, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(AttachedAreas, OfAllVerticesAreTheSurface) {
  const TriangleSoup sphere = Icosphere(10, 3);
  std::vector<Attachment> halves(2);
  halves[0].points = Eigen::RowVector3d(0, 0, 20);
  halves[0].radius = 20;
  halves[1].points = Eigen::RowVector3d(0, 0, 0);
  halves[1].radius = 11;
  const auto areas = AttachedAreas(halves,
                                   FindAttachedVertices(halves, sphere.points),
                                   sphere.points,
                                   sphere.triangles);
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(
      areas[0] + areas[1], SurfaceArea(sphere.points, sphere.triangles), 1e-9);
  // A cap of height 7.5, less what a ring of triangles adds or takes.
  EXPECT_NEAR(areas[0], 2 * M_PI * 10 * 7.5, 30);
}

TEST(AttachedPositions, MoveWithTheBodies) {
  const Line line;
  const ScenePose pose = FlexedPose(0.4);
  MuscleModel model;
  model.attachments = line.attachments;
  const Points positions =
      AttachedPositions(model, line.Attached(), line.AttachedRest(), pose);
  EXPECT_EQ(Points(positions.topRows(4)), Points(line.rest.topRows(4)));
  EXPECT_EQ(Points(positions.bottomRows(4)),
            Transformed(line.rest.bottomRows(4), pose.bodies.at("femur")));
}

TEST(DriftOf, IsTheMeanAndTheLargestDistanceOfEachArea) {
  const Line line;
  Points points = line.rest;
  points(5, 0) += 3;
  points(6, 1) -= 1;
  const auto drifts =
      DriftOf(line.attachments, line.Attached(), line.AttachedRest(), points);
  ASSERT_EQ(drifts.size(), 2u);
  EXPECT_EQ(drifts[0].body, "pelvis");
  EXPECT_EQ(drifts[0].vertices, 4);
  EXPECT_EQ(drifts[0].max, 0);
  EXPECT_EQ(drifts[1].body, "femur");
  EXPECT_NEAR(drifts[1].mean, 1, 1e-14);
  EXPECT_NEAR(drifts[1].max, 3, 1e-14);
  EXPECT_EQ(drifts[1].place, points.row(5));
}

TEST(DriftOf, OfAnAreaWithoutVerticesIsZero) {
  Line line;
  line.attachments[1].points(0, 2) = 100;
  const auto drifts = DriftOf(
      line.attachments, line.Attached(), line.AttachedRest(), line.rest);
  EXPECT_EQ(drifts[1].vertices, 0);
  EXPECT_EQ(drifts[1].mean, 0);
}

}  // namespace
}  // namespace musclewarp
