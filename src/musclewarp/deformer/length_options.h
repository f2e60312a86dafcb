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
// of the scene. This converts the latter, which `names` has by the names of
// their settings (settings/deformer_settings.h), from mm (or mm^2) to units of
// the body. Throws InputError for a gap beyond kLargestGap of the body.
// Precondition (CHECKed): each name is that of a length among the options.
void AskInMillimetres(const std::set<std::string>& names,
                      double body_size,
                      PrepareOptions* prepare,
                      CertifiedContactOptions* contact,
                      FrameRequirements* requirements);

}  // namespace musclewarp
