// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/attachment_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {

TEST(AttachmentRows, AreTheVerticesWithinTheRadius) {
  const Attachment attachment = SpindleMuscle().attachments[0];
  const Points points = Spindle(12, 60, 3).points;
  const std::vector<int> rows = VerticesWithRows(attachment, points, 10000);
  ASSERT_FALSE(rows.empty());
  for (int v = 0; v < points.rows(); ++v) {
    const bool is_near =
        (points.row(v) - attachment.points.row(0)).norm() <= attachment.radius;
    EXPECT_EQ(std::binary_search(rows.begin(), rows.end(), v), is_near);
  }
}

TEST(AttachmentRows, AreThinnedToTheLimit) {
  const Attachment attachment = SpindleMuscle().attachments[0];
  const Points points = Spindle(12, 60, 3).points;
  const std::vector<int> all = VerticesWithRows(attachment, points, 10000);
  const std::vector<int> rows = VerticesWithRows(attachment, points, 5);
  EXPECT_EQ(rows.size(), 5u);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_TRUE(std::includes(all.begin(), all.end(), rows.begin(), rows.end()));
}

}  // namespace musclewarp
