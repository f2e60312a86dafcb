// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/found_attachments.h"

#include <gtest/gtest.h>

#include <set>

#include "fibres/ball_bones.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A spindle along z from -50 to 50 and balls of bone at its ends.
class FindAttachmentsTest : public ::testing::Test {
 protected:
  std::vector<FoundAttachment> Find() const {
    return FindAttachments(muscle_, bones_.bodies(), {});
  }

  const TriangleSoup muscle_ = Spindle(10, 50, 4);
  BallBones bones_;
};

TEST_F(FindAttachmentsTest, AreTheVerticesOnTheBonesOfBothEnds) {
  bones_.Add("pelvis", {0, 0, 57});
  bones_.Add("femur", {0, 0, -52});  // the tip of the muscle is in it
  const std::vector<FoundAttachment> found = Find();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].attachment.body, "pelvis");
  EXPECT_EQ(found[1].attachment.body, "femur");
  std::set<std::vector<double>> vertices;
  for (Eigen::Index v = 0; v < muscle_.points.rows(); ++v) {
    const Eigen::RowVector3d p = muscle_.points.row(v);
    vertices.insert({p[0], p[1], p[2]});
  }
  for (const auto& [attachment, is_on_bones, tip] : found) {
    EXPECT_TRUE(is_on_bones);
    const double height = attachment.body == "pelvis" ? 57 : -52;
    EXPECT_GT(attachment.points.rows(), 5);
    EXPECT_LT(attachment.radius, 1e-3);
    EXPECT_FALSE(attachment.may_penetrate);
    for (const auto& p : attachment.points.rowwise()) {
      EXPECT_EQ(vertices.count({p[0], p[1], p[2]}), 1u);
      const double distance = (p - Eigen::RowVector3d(0, 0, height)).norm() - 8;
      // Within 3 mm of what is nearest, which touches.
      EXPECT_LT(distance, 3.01);
    }
  }
}

TEST_F(FindAttachmentsTest, TheTipIsAttachedWhereABoneIsMissing) {
  bones_.Add("femur", {0, 0, -57});
  const std::vector<FoundAttachment> found = Find();
  ASSERT_EQ(found.size(), 2u);
  for (const auto& [attachment, is_on_bones, tip] : found) {
    EXPECT_EQ(attachment.body, "femur");
    const double side = attachment.points(0, 2) > 0 ? 1 : -1;
    EXPECT_EQ(is_on_bones, side < 0);
    EXPECT_EQ(tip[2] > 45, !is_on_bones);
    // A tenth of the length of 100 mm, and a voxel.
    const double begin = (side * attachment.points.col(2).array()).minCoeff();
    EXPECT_GT(begin, 38);
    if (!is_on_bones) {
      EXPECT_LT(begin, 43);
    }
    EXPECT_GT(attachment.points.rows(), 5);
  }
  EXPECT_LT(found[0].attachment.points(0, 2) * found[1].attachment.points(0, 2),
            0);
}

TEST_F(FindAttachmentsTest, OnePatchIsTakenOfSeveral) {
  // The muscle is split into two halves that do not touch: a second spindle
  // beside, as near to the bone.
  TriangleSoup two = MovedBy(Spindle(6, 50, 4), {-7, 0, 0});
  const TriangleSoup other = MovedBy(Spindle(6, 50, 4), {7, 0, 0});
  const auto count = static_cast<int>(two.points.rows());
  two = Together(two, other);
  bones_.Add("pelvis", {0, 0, 54});
  bones_.Add("femur", {0, 0, -54});
  for (const auto& [attachment, is_on_bones, tip] :
       FindAttachments(two, bones_.bodies(), {})) {
    std::set<bool> sides;
    for (const auto& p : attachment.points.rowwise()) sides.insert(p[0] > 0);
    EXPECT_EQ(sides.size(), 1u);
  }
  EXPECT_EQ(two.points.rows(), 2 * count);
}

TEST_F(FindAttachmentsTest, NoneWithoutBones) { EXPECT_TRUE(Find().empty()); }

}  // namespace
}  // namespace musclewarp
