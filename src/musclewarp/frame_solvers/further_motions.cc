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

// Returns by how much contact has moved a muscle farther than allowed, mm, at
// most; 0 if none.
double ExcessOf(const FrameRequirements& requirements, const Frame& frame) {
  double excess = 0;
  for (const MuscleFrame& muscle : frame.muscles) {
    excess = std::max(excess,
                      muscle.max_contact_displacement -
                          AllowedDisplacement(requirements, muscle));
  }
  return excess;
}

// Moves on from where `before` ended.
CertifiedMove MoveOn(const MoveFrom& move,
                     const CertifiedMove& before,
                     Settling settling) {
  CertifiedMove next = move(before.motion.state, settling);
  next.motion.summary.steps += before.motion.summary.steps;
  next.moving_ms += before.moving_ms;
  next.certifying_ms += before.certifying_ms;
  return next;
}

}  // namespace

CertifiedMove MoveUntilSound(const MoveFrom& move,
                             const ContactState& start,
                             double gap,
                             const FrameRequirements& requirements) {
  CertifiedMove best = move(start, Settling::kIfPushed);
  for (int further = 0; further < kMaxFurtherMotions; ++further) {
    const double narrowest = NarrowestGap(best.frame);
    if (best.Crosses() || narrowest >= gap) break;
    CertifiedMove next = MoveOn(move, best, Settling::kIfPushed);
    if (next.Crosses() || NarrowestGap(next.frame) <= narrowest) break;
    best = std::move(next);
  }
  for (int further = 0; further < kMaxFurtherMotions; ++further) {
    const double excess = ExcessOf(requirements, best.frame);
    if (best.Crosses() || excess == 0) break;
    const double apart = std::min(gap, NarrowestGap(best.frame));
    CertifiedMove next = MoveOn(move, best, Settling::kFully);
    if (next.Crosses() || NarrowestGap(next.frame) < apart ||
        ExcessOf(requirements, next.frame) >= excess) {
      break;
    }
    best = std::move(next);
  }
  return best;
}

}  // namespace musclewarp
