// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"

namespace musclewarp {

// What two meshes of a scene that touch have in common. Pairs of triangles are
// found by an exact test.
struct PairFigures {
  std::string a;
  std::string b;
  int triangle_pairs = 0;
  int vertices_inside = 0;
  double max_depth_mm = 0;
  int exempt_pairs = 0;

  // Where to look, mm: the mean of the corners of triangles_of_a, or a vertex
  // inside if no triangles cross.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();

  // The triangles that cross, ascending, each once, without exempt ones.
  std::vector<int> triangles_of_a;
  std::vector<int> triangles_of_b;

  // The numbers of a and b among the muscles; that of a bone is -1.
  int muscle_a = -1;
  int muscle_b = -1;

  // True if more than exempt triangles cross, or one mesh has a vertex inside
  // the other.
  bool Counts() const { return triangle_pairs + vertices_inside > 0; }
};

constexpr auto FieldsOf(Described<PairFigures>) {
  using F = PairFigures;
  return std::make_tuple(
      Field(&F::a, "a").Text("a muscle"),
      Field(&F::b, "b").Text("another muscle, or a bone"),
      Field(&F::triangle_pairs, "triangle_pairs")
          .Text(
              "pairs of a triangle of each that share a point, by exact tests")
          .AtLeast(0),
      Field(&F::vertices_inside, "vertices_inside")
          .Text("vertices of one inside the other, either way")
          .AtLeast(0),
      Field(&F::max_depth_mm, "max_depth_mm", "mm")
          .Text("the depth of the deepest of these vertices")
          .AtLeast(0),
      Field(&F::exempt_pairs, "exempt_pairs")
          .Text("pairs of triangles of attachment areas that may penetrate, "
                "which the other counts leave out")
          .AtLeast(0),
      NotWritten(&F::place, "mm"),
      NotWritten(&F::triangles_of_a),
      NotWritten(&F::triangles_of_b),
      NotWritten(&F::muscle_a),
      NotWritten(&F::muscle_b));
}

// Gaps between two meshes are looked for up to this width, mm.
constexpr double kMeshGapLimit = 2;

// The smallest distance of two meshes of a scene that are near each other. It
// is proved to be in [at_least_mm, at_most_mm], whatever rounding does; the two
// differ by rounding only (see MeshDistance). Both are 0 if triangles of the
// meshes cross or one mesh contains a vertex of the other.
struct MeshGap {
  std::string a;
  std::string b;
  double at_least_mm = 0;
  double at_most_mm = 0;

  // The mid-point of the closest points, or where the meshes intersect, mm.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();

  // As in PairFigures.
  int muscle_a = -1;
  int muscle_b = -1;
};

constexpr auto FieldsOf(Described<MeshGap>) {
  using F = MeshGap;
  return std::make_tuple(
      Field(&F::a, "a").Text("a muscle"),
      Field(&F::b, "b").Text("another muscle, or a bone"),
      Field(&F::at_least_mm, "at_least_mm", "mm")
          .Text("proved lower bound of the smallest distance of the two "
                "surfaces; 0 if the meshes intersect")
          .AtLeast(0),
      Field(&F::at_most_mm, "at_most_mm", "mm")
          .Text("proved upper bound, which differs by rounding only")
          .AtLeast(0),
      Field(&F::place, "place_mm", "mm")
          .Text("the middle between the closest points"),
      NotWritten(&F::muscle_a),
      NotWritten(&F::muscle_b));
}

// What intersects in a scene: sums over all pairs of two muscles and of a
// muscle and a bone, and the pairs themselves.
struct SceneIntersections {
  int triangle_pairs = 0;
  int vertices_inside = 0;
  double max_depth_mm = 0;
  int self_pairs = 0;
  int exempt_pairs = 0;
  std::vector<int> self_pairs_of_muscles;
  std::vector<PairFigures> pairs;  // those that touch, in scene order

  // The pairs of two muscles or of a muscle and a bone that are at most
  // kMeshGapLimit apart, in scene order. Pairs that are not here are proved to
  // be farther apart. Exempt triangles do not count.
  std::vector<MeshGap> gaps;

  // By muscle: its vertices inside any other mesh, ascending.
  std::vector<std::vector<int>> inside_of_muscles;

  // True if no triangles of two meshes cross and no vertex is inside another
  // mesh.
  bool IsClean() const { return triangle_pairs == 0 && vertices_inside == 0; }

  // Returns the proved width of the narrowest gap, mm, or nothing if there is
  // no gap of at most kMeshGapLimit.
  std::optional<double> SmallestGap() const;

  // Deletes the lists of triangles and vertices and keeps the counts.
  void DropLists();
};

// The gaps are a list of their own in a report.
constexpr auto FieldsOf(Described<SceneIntersections>) {
  using F = SceneIntersections;
  return std::make_tuple(
      Field(&F::triangle_pairs, "triangle_pairs")
          .Text("pairs of triangles of two muscles, or of a muscle and a bone, "
                "that share a point, by exact tests")
          .AtLeast(0),
      Field(&F::vertices_inside, "vertices_inside")
          .Text("vertices of one mesh inside another")
          .AtLeast(0),
      Field(&F::max_depth_mm, "max_depth_mm", "mm")
          .Text("the depth of the deepest of these vertices")
          .AtLeast(0),
      Field(&F::self_pairs, "self_pairs")
          .Text("pairs of triangles of the same muscle that cross each other")
          .AtLeast(0),
      Field(&F::exempt_pairs, "exempt_pairs")
          .Text("pairs of triangles of attachment areas that may penetrate, "
                "which the other counts leave out")
          .AtLeast(0),
      Field(&F::pairs, "pairs")
          .Text("the same for every two meshes that touch"),
      NotWritten(&F::self_pairs_of_muscles),
      NotWritten(&F::gaps),
      NotWritten(&F::inside_of_muscles));
}

}  // namespace musclewarp
