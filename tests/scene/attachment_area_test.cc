// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/attachment_area.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Vertices at 0, 1, ..., 9 mm on the x axis.
Points TenVertices() {
  Points points = Points::Zero(10, 3);
  for (int i = 0; i < 10; ++i) points(i, 0) = i;
  return points;
}

Attachment At(const Points& points, double radius) {
  Attachment attachment;
  attachment.points = points;
  attachment.radius = radius;
  return attachment;
}

TEST(VerticesInArea, AreThoseWithinTheRadiusOfAnyPointInRisingOrder) {
  Points points(2, 3);
  points << 8, 0, 0, 1, 0, 0;
  EXPECT_THAT(VerticesInArea(At(points, 1), TenVertices()),
              ElementsAre(0, 1, 2, 7, 8, 9));
}

TEST(VerticesInArea, CountTheBorderOfTheBall) {
  Points points(1, 3);
  points << 4, 3, 0;
  // 3-4-5 triangles: the vertices at 0 and 8 are exactly 5 mm away.
  EXPECT_THAT(VerticesInArea(At(points, 5), TenVertices()),
              ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(VerticesInArea(At(points, 2.999), TenVertices()), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
