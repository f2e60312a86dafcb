// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/surface_reconstruction.h"

namespace musclewarp {

std::string ToString(ReconstructionReason reason) {
  switch (reason) {
    case ReconstructionReason::kCrossesBone:
      return "crosses_bone";
    case ReconstructionReason::kCrossesMuscle:
      return "crosses_muscle";
    case ReconstructionReason::kCrossesItself:
      return "crosses_itself";
    case ReconstructionReason::kDisplaced:
      return "displaced";
  }
  return "unknown";
}

}  // namespace musclewarp
