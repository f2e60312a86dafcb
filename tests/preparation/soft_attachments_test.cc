// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/soft_attachments.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {
namespace {

FoundAttachment FoundAt(double height, bool is_on_bones) {
  FoundAttachment found;
  found.attachment.body = is_on_bones ? "femur" : "tibia";
  found.attachment.points.resize(3, 3);
  found.attachment.points << 0, 0, height, 0, 0, height + 2, 0, 0, height + 9;
  found.is_on_bones = is_on_bones;
  return found;
}

TEST(TakeSoftAttachment, TakesWhatLiesOnThePartOfTheNearestEnd) {
  const TriangleSoup tendon = SphereAt({0, 0, -20}, 20, 4);
  const TriangleBvh surface(tendon.points, tendon.triangles);
  // The end counts even if it lies on a bone as well.
  for (const bool is_on_bones : {false, true}) {
    std::vector<FoundAttachment> found = {FoundAt(80, true),
                                          FoundAt(0.5, is_on_bones)};
    const auto attachment = TakeSoftAttachment(surface, "tendon", &found);
    ASSERT_TRUE(attachment);
    EXPECT_EQ(attachment->soft_part, "tendon");
    EXPECT_TRUE(attachment->body.empty());
    EXPECT_EQ(attachment->points.rows(), 2);  // the third is 9 mm farther away
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].attachment.points(0, 2), 80);
  }
}

TEST(TakeSoftAttachment, IsNothingWithoutEnds) {
  const TriangleSoup tendon = Icosphere(5, 2);
  const TriangleBvh surface(tendon.points, tendon.triangles);
  std::vector<FoundAttachment> none;
  EXPECT_FALSE(TakeSoftAttachment(surface, "tendon", &none));
}

}  // namespace
}  // namespace musclewarp
