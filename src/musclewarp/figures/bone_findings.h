// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/base/described.h"

namespace musclewarp {

// Two bones of different bodies that lie in each other in a pose, because the
// pose moves them there or because they were delivered like that. Muscles
// between them have no room there, whatever contact does: they are squeezed, or
// leave the bone that they are attached to.
struct BoneOverlap {
  std::string a;
  std::string b;
  double depth_mm = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

constexpr auto FieldsOf(Described<BoneOverlap>) {
  using F = BoneOverlap;
  return std::make_tuple(
      Field(&F::a, "a").Text("a bone"),
      Field(&F::b, "b").Text("a bone of another body"),
      Field(&F::depth_mm, "depth_mm", "mm")
          .Text("the depth of the deepest vertex of one in the other")
          .AtLeast(0),
      Field(&F::place, "place_mm", "mm").Text("where that vertex is"));
}

// What a muscle has in common with the triangles of a bone that only the
// delivered mesh has (certificate/delivered_crossings.h).
struct DeliveredCrossing {
  std::string muscle;
  std::string bone;
  int triangle_pairs = 0;
  int pieces_inside = 0;

  // The mean of the corners of the muscle's triangles that cross, or a point of
  // a piece inside if none do, mm.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

constexpr auto FieldsOf(Described<DeliveredCrossing>) {
  using F = DeliveredCrossing;
  return std::make_tuple(
      Field(&F::muscle, "muscle").Text("the muscle"),
      Field(&F::bone, "bone").Text("the bone"),
      Field(&F::triangle_pairs, "triangle_pairs")
          .Text("pairs of triangles that cross, by exact tests")
          .AtLeast(0),
      Field(&F::pieces_inside, "pieces_inside")
          .Text("pieces of the bone that lie within the muscle")
          .AtLeast(0),
      Field(&F::place, "place_mm", "mm").Text("where to look"));
}

}  // namespace musclewarp
