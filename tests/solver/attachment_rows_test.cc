// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/attachment_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {

TEST(AttachmentRows, AreTheVerticesWithinTheRadius) {
  const Attachment attachment = SpindleMuscle().attachments[0];
  const Points points = Spindle(12, 60, 3).points;
  const std::vector<int> rows = EqualRows(attachment, points, 10000).vertices;
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
  const std::vector<int> all = EqualRows(attachment, points, 10000).vertices;
  const std::vector<int> rows = EqualRows(attachment, points, 5).vertices;
  EXPECT_EQ(rows.size(), 5u);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_TRUE(std::includes(all.begin(), all.end(), rows.begin(), rows.end()));
}

TEST(AttachmentRows, WeighByTheAreaAroundThem) {
  const Attachment attachment = SpindleMuscle().attachments[0];
  const TriangleSoup mesh = Spindle(12, 60, 3);
  const Eigen::VectorXd areas = VertexAreas(mesh.points, mesh.triangles);
  const AttachmentRows all = RowsByArea(attachment, mesh.points, areas, 10000);
  const auto in_area = EqualRows(attachment, mesh.points, 10000).vertices;
  ASSERT_EQ(all.vertices.size(), in_area.size());
  const double sum = areas(in_area).sum();
  for (size_t i = 0; i < all.vertices.size(); ++i) {
    EXPECT_NEAR(all.weights[i],
                std::sqrt(areas[all.vertices[i]] / sum),
                1e-15);  // rounding
  }
  const AttachmentRows few = RowsByArea(attachment, mesh.points, areas, 5);
  ASSERT_EQ(few.vertices.size(), 5u);
  double squares = 0;
  for (const double weight : few.weights) squares += weight * weight;
  EXPECT_NEAR(squares, 1, 1e-14);  // rounding
}

// The weighted mean of the places of the rows is that of the area.
TEST(AttachmentRows, ByAreaAreTheSameOnAFinerMesh) {
  const Attachment attachment = SpindleMuscle().attachments[0];
  const auto middle = [&](int levels) {
    const TriangleSoup mesh = Spindle(12, 60, levels);
    const AttachmentRows rows = RowsByArea(
        attachment, mesh.points, VertexAreas(mesh.points, mesh.triangles), 32);
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (size_t i = 0; i < rows.vertices.size(); ++i) {
      sum +=
          rows.weights[i] * rows.weights[i] * mesh.points.row(rows.vertices[i]);
    }
    return sum;
  };
  EXPECT_LT((middle(3) - middle(4)).norm(), 1);  // mm, of edges of 2 mm
}

}  // namespace musclewarp
