// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/further_motions.h"

#include <algorithm>
#include <utility>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

constexpr int kMaxFurtherMotions = 2;

// Returns the narrowest gap of meshes that do not intersect, mm, or infinity.
// Attachment areas that may penetrate have none.
double NarrowestGap(const Frame& frame) {
  double narrowest = kInfinity;
  for (const MeshGap& gap : frame.intersections.gaps) {
    if (gap.at_most_mm > 0) narrowest = std::min(narrowest, gap.at_least_mm);
  }
  return narrowest;
}

}  // namespace

CertifiedMove MoveUntilApart(
    const std::function<CertifiedMove(const ContactState&)>& move,
    const ContactState& start,
    double gap) {
  CertifiedMove best = move(start);
  for (int further = 0; further < kMaxFurtherMotions; ++further) {
    const double narrowest = NarrowestGap(best.frame);
    if (best.Crosses() || narrowest >= gap) break;
    CertifiedMove next = move(best.motion.state);
    next.motion.summary.steps += best.motion.summary.steps;
    next.moving_ms += best.moving_ms;
    next.certifying_ms += best.certifying_ms;
    if (next.Crosses() || NarrowestGap(next.frame) <= narrowest) break;
    best = std::move(next);
  }
  return best;
}

}  // namespace musclewarp
