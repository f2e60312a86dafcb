// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// A muscle of a model that pulls along one line. A muscle with several lines is
// as many of these, which share its volume.
struct LineMuscle {
  // Has a body for every point, and the name of the muscle of the model.
  ActionLine line;
  double volume = 0;  // mm^3
};

// What OpenSim's muscles have besides a path. Shapes do not tell any of it:
// these are estimates, for a first simulation, to be replaced by measurements.
struct MuscleEstimate {
  double max_isometric_force = 0;   // N
  double optimal_fibre_length = 0;  // mm
  double tendon_slack_length = 0;   // mm
  double pennation = 0;             // at the optimal fibre length, rad
};

// The force of a muscle by its physiological cross-section, N/mm^2.
//
// Source: 60 N/cm^2, as in Rajagopal et al. 2016, Full-Body Musculoskeletal
// Model for Muscle-Driven Simulation of Human Gait, IEEE Trans. Biomed. Eng.
// 63, doi:10.1109/TBME.2016.2586891. It is chosen there so that joints reach
// the moments of living people; fibres in a dish have about 23 N/cm^2.
constexpr double kSpecificTension = 0.6;

// The optimal fibre length by the length of a line from bone to bone.
//
// Source: the median of optimal_fiber_length / (optimal_fiber_length *
// cos(pennation) + tendon_slack_length) over the 46 muscles of the right side
// of OpenSim's gait2392, whose data are of Delp et al. 1990. They have 0.08 (a
// flexor of the toes) to 0.87 (adductor brevis).
constexpr double kFibreShare = 0.42;

// Returns the estimates for a muscle at rest, with no pennation:
//
//   optimal fibre length = kFibreShare * length of the line
//   force = kSpecificTension * volume / optimal fibre length
//   tendon slack length = length of the line - optimal fibre length
//
// so that fibres are at their optimal length, and the tendon is slack, at rest.
// Preconditions (CHECKed): volume and length are above 0.
MuscleEstimate EstimateMuscle(const LineMuscle& muscle);

// The characters that OpenSim 4 refuses in the names of the parts of a model.
// Source: ComponentPath of opensim-core 4.
constexpr char kNotInOpenSimNames[] = "\\/*+ \t\n";

}  // namespace musclewarp
