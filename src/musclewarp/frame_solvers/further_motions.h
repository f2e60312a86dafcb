// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/motion/certified_motion.h"

namespace musclewarp {

// A motion to a pose, and its frame.
struct CertifiedMove {
  CertifiedMotion motion;
  Frame frame;
  double moving_ms = 0, certifying_ms = 0;

  bool Crosses() const {
    return motion.last_clean || frame.intersections.triangle_pairs > 0;
  }
};

// Moves to a pose from a state.
using MoveFrom =
    std::function<CertifiedMove(const ContactState& start, Settling settling)>;

// Moves on from `start`, and again to the same pose while that helps, at most
// twice for either reason:
//
// - Surfaces are nearer than the gap (mm) without crossing: a step keeps
//   muscles in the planes of what was near when it began. Along a rugged bone
//   they may slide to where it comes nearer than the gap; another motion to the
//   same pose then finds the planes that were missing.
// - Contact has moved a muscle farther than allowed (AllowedDisplacement). What
//   it moved in an earlier pose comes back slowly; muscles then settle fully.
//
// Steps and times are those of all motions up to the one that is returned.
CertifiedMove MoveUntilSound(const MoveFrom& move,
                             const ContactState& start,
                             double gap,
                             const FrameRequirements& requirements);

}  // namespace musclewarp
