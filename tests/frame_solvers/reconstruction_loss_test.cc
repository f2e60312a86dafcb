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
