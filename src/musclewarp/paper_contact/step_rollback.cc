// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/step_rollback.h"

#include <utility>

namespace musclewarp {
namespace {

// Shorter steps, mm, are rounding and have no meaningful direction.
constexpr double kNoStep = 1e-12;

double LongestStep(const Points& before, const ContactBody& body) {
  if (!body.is_deformable()) return 0;
  return (body.points() - before).rowwise().norm().maxCoeff();
}

// How far back the surface is looked for, as a multiple of the longest steps of
// the two bodies together, since either may have moved into the other. A
// surface farther away is not where the vertex came in, but the far side of the
// body.
constexpr double kReachPerStep = 1;

Points RolledBack(const PaperContactOptions& options,
                  double reach,
                  const Points& before,
                  const std::vector<int>& inside,
                  const ContactBody& body,
                  const ContactBody& other) {
  const double share = other.is_deformable() ? options.deformable_fraction : 1;
  Points points = body.points();
  for (const int v : inside) {
    const Eigen::RowVector3d back = before.row(v) - points.row(v);
    const double step = back.norm();
    if (step < kNoStep) continue;
    const Eigen::RowVector3d unit = back / step;
    const double way = other.DistanceAlong(points.row(v), unit);
    if (way <= reach) {
      points.row(v) += (share * way + options.clearance) * unit;
    } else {
      points.row(v) = before.row(v);
    }
  }
  return points;
}

}  // namespace

void RollBackStep(const PaperContactOptions& options,
                  const Points& before_a,
                  const Points& before_b,
                  ContactBody* a,
                  ContactBody* b,
                  std::vector<char>* found_a,
                  std::vector<char>* found_b) {
  const double reach =
      kReachPerStep * (LongestStep(before_a, *a) + LongestStep(before_b, *b));
  // Both bodies are tested before either moves.
  std::vector<int> inside_a, inside_b;
  if (a->is_deformable()) inside_a = b->Inside(a->points());
  if (b->is_deformable()) inside_b = a->Inside(b->points());
  Points moved_a, moved_b;
  if (!inside_a.empty()) {
    moved_a = RolledBack(options, reach, before_a, inside_a, *a, *b);
  }
  if (!inside_b.empty()) {
    moved_b = RolledBack(options, reach, before_b, inside_b, *b, *a);
  }
  if (!inside_a.empty()) a->MoveTo(std::move(moved_a));
  if (!inside_b.empty()) b->MoveTo(std::move(moved_b));
  for (const int v : inside_a) (*found_a)[v] = true;
  for (const int v : inside_b) (*found_b)[v] = true;
}

}  // namespace musclewarp
