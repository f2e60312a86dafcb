// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/joints/articulation.h"
#include "musclewarp/joints/line_muscle.h"
#include "musclewarp/subject/subject.h"

namespace musclewarp {

// The muscles of a subject for a model of its skeleton.
struct LineMuscles {
  // At rest: an entry for each line that musclewarp-deform makes for the
  // muscles with its defaults, which is certified contact, under the same name.
  // Lines of a muscle have equal shares of its volume.
  std::vector<LineMuscle> muscles;

  // A sentence for each tendon of which there is no mesh (bare_tendons.h).
  std::vector<std::string> warnings;

  // Why there are none although the subject has muscles, such as a mesh that
  // cannot be repaired, or muscles without bones near. Empty if all is well.
  std::string why_none;
};

// Returns the muscles of a subject. `mm_per_unit` is the unit of its files.
// Throws InputError for ends on bodies that the articulation does not have
// (EndBodiesOf). Precondition (CHECKed): the articulation is of the bones of
// the subject.
LineMuscles LineMusclesOf(const Subject& subject,
                          const Articulation& articulation,
                          double mm_per_unit);

}  // namespace musclewarp
