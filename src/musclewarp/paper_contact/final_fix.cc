// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/final_fix.h"

#include <utility>
#include <vector>

#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// Returns the points of `body` with those inside `other` moved to its surface.
Points PushedOut(const PaperContactOptions& options,
                 const std::vector<int>& inside,
                 const ContactBody& body,
                 const ContactBody& other) {
  const double share = other.is_deformable() ? options.deformable_fraction : 1;
  Points points = body.points();
  for (const int v : inside) {
    const TriangleBvh::Closest closest = other.Closest(points.row(v));
    if (!(closest.distance > 0)) continue;
    const Eigen::RowVector3d way = closest.point - points.row(v);
    points.row(v) += (share + options.clearance / closest.distance) * way;
  }
  return points;
}

// A triangle and the move that takes it off a vertex of an obstacle.
struct TriangleMove {
  int triangle = -1;  // -1: there is none to move
  Eigen::RowVector3d move;
};

// Finds the triangle of `body` that a vertex of an obstacle came through, by
// going back from the vertex against the normal of the obstacle. The closest
// triangle would be the wrong one if it is on the other side of a thin muscle.
// Returns none if the triangle is too far away for a mere correction.
TriangleMove MoveOff(const PaperContactOptions& options,
                     const Eigen::RowVector3d& vertex,
                     const Eigen::RowVector3d& normal,
                     const ContactBody& body) {
  const double way = body.DistanceAlong(vertex, -normal);
  if (way > options.pairing_fraction * body.shape().bounding_radius) return {};
  return {body.Closest(vertex - way * normal).triangle,
          (way + options.clearance) * normal};
}

// Moves the triangles of `body` off the vertices of an obstacle that are inside
// it. A corner makes the longest of the moves asked of it.
void PushTriangles(const PaperContactOptions& options,
                   const std::vector<int>& inside,
                   const ContactBody& obstacle,
                   const ContactBody& body,
                   Points* points) {
  if (inside.empty()) return;
  const Points outward =
      VolumeGradient(obstacle.points(), obstacle.shape().triangles);
  Points moves = Points::Zero(points->rows(), 3);
  for (const int v : inside) {
    const double length = outward.row(v).norm();
    if (!(length > 0)) continue;
    const TriangleMove push = MoveOff(
        options, obstacle.points().row(v), outward.row(v) / length, body);
    if (push.triangle < 0) continue;
    for (int c = 0; c < 3; ++c) {
      const int corner = body.shape().triangles(push.triangle, c);
      if (push.move.squaredNorm() > moves.row(corner).squaredNorm()) {
        moves.row(corner) = push.move;
      }
    }
  }
  *points += moves;
}

}  // namespace

bool PushOut(const PaperContactOptions& options,
             ContactBody* a,
             ContactBody* b) {
  // Both bodies are tested before either moves.
  const std::vector<int> inside_a = b->Inside(a->points());
  const std::vector<int> inside_b = a->Inside(b->points());
  if (inside_a.empty() && inside_b.empty()) return false;
  Points moved_a = PushedOut(options, inside_a, *a, *b);
  if (b->is_deformable()) {
    b->MoveTo(PushedOut(options, inside_b, *b, *a));
  } else {
    PushTriangles(options, inside_b, *b, *a, &moved_a);
  }
  a->MoveTo(std::move(moved_a));
  return true;
}

}  // namespace musclewarp
