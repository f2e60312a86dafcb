// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_model.h"

#include <gtest/gtest.h>

#include "exchange/small_model.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

double VolumeOf(const MuscleElements& muscle, const TetrahedralMesh& mesh) {
  return Volumes(mesh).segment(muscle.first_element, muscle.num_elements).sum();
}

TEST(ElementModel, PutsTheElementsOfAMuscleTogether) {
  const SmallModel small = MakeSmallModel();
  const ElementModel model = small.Model();
  ASSERT_EQ(model.muscles.size(), 2u);
  int element = 0;
  for (size_t i = 0; i < 2; ++i) {
    const MuscleElements& muscle = model.muscles[i];
    const TriangleSoup& soup = small.pose.muscles[i];
    EXPECT_EQ(muscle.name, small.names.muscles[i]);
    EXPECT_EQ(muscle.first_element, element);
    element += muscle.num_elements;
    EXPECT_NEAR(VolumeOf(muscle, model.mesh),
                SignedVolume(soup.points, soup.triangles),
                1e-9);  // of 4000 mm^3
    ASSERT_EQ(muscle.faces.size(), static_cast<size_t>(soup.triangles.rows()));
    for (size_t f = 0; f < muscle.faces.size(); ++f) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (const int k : kFaceCorners[muscle.faces[f].face]) {
        const int v = model.mesh.tetrahedra(muscle.faces[f].tetrahedron, k);
        sum += model.mesh.points.row(v);
      }
      Eigen::RowVector3d expected = Eigen::RowVector3d::Zero();
      for (const int v : soup.triangles.row(f)) expected += soup.points.row(v);
      EXPECT_LT((sum - expected).norm(), 1e-13);
    }
    EXPECT_EQ(model.mesh.points.row(muscle.surface(3, 1)),
              soup.points.row(soup.triangles(3, 1)));
  }
  EXPECT_EQ(element, model.mesh.tetrahedra.rows());
}

TEST(ElementModel, KnowsFibresAttachmentsBodiesAndContacts) {
  const SmallModel small = MakeSmallModel();
  const ElementModel model = small.Model();
  const MuscleElements& psoas = model.muscles[0];
  const Eigen::RowVector3d along(0, 0.6, 0.8);
  for (int t = 0; t < psoas.num_elements; ++t) {
    EXPECT_LT((model.fibres.row(psoas.first_element + t) - along).norm(),
              1e-15);
  }
  const MuscleElements& iliacus = model.muscles[1];
  EXPECT_TRUE(
      model.fibres.middleRows(iliacus.first_element, iliacus.num_elements)
          .isZero(0));
  ASSERT_EQ(psoas.attachments.size(), 1u);
  EXPECT_EQ(psoas.attachments[0].vertices,
            small.attachments.muscles.at("psoas")[0].vertices);
  EXPECT_TRUE(iliacus.attachments.empty());
  ASSERT_EQ(model.bones.size(), 1u);
  EXPECT_EQ(model.bones[0].body, "thigh");
  ASSERT_EQ(model.contacts.size(), 1u);
  EXPECT_EQ(model.contacts[0].b, "iliacus");
  EXPECT_EQ(model.contacts[0].gap_mm, 1.25);
}

TEST(ElementModel, AttachmentsAreNodesOfTheMesh) {
  SmallModel small = MakeSmallModel();
  small.attachments.muscles["iliacus"] = {{"pelvis", {0, 2}}};
  small.attachments.bones.clear();
  const ElementModel model = small.Model();
  const auto first = static_cast<int>(small.pose.muscles[0].points.rows());
  EXPECT_EQ(model.muscles[1].attachments[0].vertices,
            (std::vector<int>{first, first + 2}));
  EXPECT_EQ(model.bones[0].body, "femur");  // as nobody says
}

TEST(ElementModel, TakesActionLinesWhereThereAreNoFibres) {
  SmallModel small = MakeSmallModel();
  // The first piece has no length, and so no direction.
  small.pose.lines[1].lines = {
      {"line", Points{{22, 0, -5}, {22, 0, -5}, {22, 0, 5}}}};
  const ElementModel model = small.Model();
  const Eigen::RowVector3d fibre =
      model.fibres.row(model.muscles[1].first_element);
  EXPECT_EQ(fibre, Eigen::RowVector3d(0, 0, 1));
}

}  // namespace
}  // namespace musclewarp
