// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/muscle_facts.h"
#include "musclewarp/preparation/surroundings.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// A side of a muscle on which its lines do not end where they should.
struct MissedSide {
  bool is_origin = false;   // or the insertion
  std::string bone;         // as anatomy calls it, or the body if it is named
  std::string body;         // with which it moves
  bool is_by_name = false;  // of the muscle; or the scene names the body
  std::vector<AnatomicalEnd> landmarks;  // on its bodies, perhaps none
};

// Most segmentations leave tendons out, and what is left of a muscle ends on
// one body alone. Returns the sides on which the lines that were made for a
// muscle end on no bone on which, by its name, anatomy has it end
// (FindMuscleFacts), though the scene has such a bone. Bones of the muscle's
// side count, if the names tell the sides. The bodies that the scene names
// (end_bodies) go before names: they are missed by lines that end more than
// kFarEnd from their bones. None is returned of names that are not known, and
// of muscles both of whose sides are on one body.
std::vector<MissedSide> MissedSides(const SceneMuscle& muscle,
                                    const std::vector<ActionLine>& lines,
                                    const Surroundings& surroundings);

// Returns a sentence for each side that a muscle misses by its name.
std::vector<std::string> MissedBones(const SceneMuscle& muscle,
                                     const std::vector<ActionLine>& lines,
                                     const Surroundings& surroundings);

}  // namespace musclewarp
