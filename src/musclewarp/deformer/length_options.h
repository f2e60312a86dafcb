// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Lengths and areas among options are those that suit people, and follow the
// size of the body (Scene::body_size), but for those that a user asks for in mm
// of the scene. These can be asked for, by the names of their flags.
const std::set<std::string>& LengthsThatCanBeAskedFor();

// Converts options that are asked for in mm (or mm^2) to units of the body.
// Throws InputError for a gap beyond kLargestGap of the body. Precondition
// (CHECKed): the names are among LengthsThatCanBeAskedFor().
void AskInMillimetres(const std::set<std::string>& names,
                      double body_size,
                      PrepareOptions* prepare,
                      CertifiedContactOptions* contact,
                      FrameRequirements* requirements);

// Meshes that overlap are separated by so many gaps, so that the steps that
// follow find room.
constexpr double kMarginByGap = 2;

// The largest gap that may be kept in a body of human size, mm: beyond, the
// steps in which surfaces move would have to be longer, too.
constexpr double kLargestGap = 0.5;

}  // namespace musclewarp
