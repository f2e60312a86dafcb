// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/exchange/run_paths.h"

namespace musclewarp {

// A muscle of a model that stands for a band of fibres.
struct BandMuscle {
  std::string name;
  std::string like;                   // the muscle that it is a copy of
  std::vector<std::string> replaces;  // muscles that go: those of all bands
  double force = 0;                   // max_isometric_force, N
  double tendon = 0;  // tendon_slack_length, mm, at least kShortestTendon
};

// OpenSim needs a tendon, mm.
constexpr double kShortestTendon = 1;

// Returns the muscles of bands (MeasuredPath::fibres) that replace muscles of
// the model: as strong as the share of their fibres in all of those, with the
// lengths of fibres and all else of the nearest one. The tendon is longer by as
// much as the band is, so that fibres work at the same lengths. Throws
// InputError if the model gives no force or tendon of a muscle.
std::vector<BandMuscle> BandMusclesOf(const RunPaths& paths);

// Returns the text of an OpenSim model in which bands take the place of
// muscles, also in the <members> of groups; they keep the paths of those that
// they are copies of. `bytes` may be in the encodings of DecodeXml, the result
// is UTF-8. Throws InputError if the text is not XML, lacks a muscle, or has
// another one with the name of a band.
std::string WithBandMuscles(const std::string& bytes,
                            const std::string& where,
                            const std::vector<BandMuscle>& bands);

}  // namespace musclewarp
