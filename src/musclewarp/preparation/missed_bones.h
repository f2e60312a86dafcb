// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/preparation/line_ends.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns a sentence for each side on which the lines that were made for a
// muscle (`ends`) do not end on a bone on which, by its name, anatomy has it
// end (FindMuscleFacts), though the scene has that bone: most segmentations
// leave tendons out, and what is left of a muscle crosses no joint. Only bones
// of joints count (BoneKind), those of the muscle's side if the names tell the
// sides. Nothing is said of names that are not known, of muscles both of whose
// ends are on one body, and where the scene names the bodies (end_bodies).
std::vector<std::string> MissedBones(const SceneMuscle& muscle,
                                     const std::vector<LineEnd>& ends,
                                     const std::vector<SceneBone>& bones);

}  // namespace musclewarp
