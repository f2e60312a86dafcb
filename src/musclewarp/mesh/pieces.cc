// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/pieces.h"

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {

std::vector<TriangleSoup> PiecesOf(const TriangleSoup& soup) {
  const Components components = ConnectedComponents(
      soup.triangles, EdgeUses(soup.triangles), soup.triangles.rows());
  std::vector<int> count(components.count, 0);
  for (const int label : components.label) ++count[label];
  std::vector<TriangleSoup> pieces(components.count);
  for (int label = 0; label < components.count; ++label) {
    pieces[label].triangles.resize(count[label], 3);
    count[label] = 0;
  }
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const int label = components.label[f];
    pieces[label].triangles.row(count[label]++) = soup.triangles.row(f);
  }
  for (TriangleSoup& piece : pieces) {
    piece.points = soup.points;
    DropUnreferencedPoints(&piece);
  }
  return pieces;
}

TriangleSoup Joined(const std::vector<TriangleSoup>& pieces) {
  Eigen::Index num_points = 0, num_triangles = 0;
  for (const TriangleSoup& piece : pieces) {
    num_points += piece.points.rows();
    num_triangles += piece.triangles.rows();
  }
  TriangleSoup joined;
  joined.points.resize(num_points, 3);
  joined.triangles.resize(num_triangles, 3);
  Eigen::Index point = 0, triangle = 0;
  for (const TriangleSoup& piece : pieces) {
    joined.points.middleRows(point, piece.points.rows()) = piece.points;
    joined.triangles.middleRows(triangle, piece.triangles.rows()) =
        piece.triangles.array() + static_cast<int>(point);
    point += piece.points.rows();
    triangle += piece.triangles.rows();
  }
  return joined;
}

double EnclosedVolume(const TriangleSoup& piece) {
  Eigen::RowVector3d tip = Eigen::RowVector3d::Zero();
  int border_edges = 0;
  for (const EdgeUses::Uses& uses : EdgeUses(piece.triangles)) {
    if (uses.size() != 1) continue;
    tip += (piece.points.row(OriginOf(piece.triangles, uses[0])) +
            piece.points.row(TargetOf(piece.triangles, uses[0]))) /
           2;
    ++border_edges;
  }
  if (border_edges > 0) tip /= border_edges;
  // SignedVolume sums cones over the triangles whose tip is the first point.
  Points points(piece.points.rows() + 1, 3);
  points << tip, piece.points;
  return SignedVolume(points, piece.triangles.array() + 1);
}

}  // namespace musclewarp
