// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/kept_planes.h"
#include "musclewarp/certified_contact/separating_planes.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// Returns the plane that keeps triangle `f` of a muscle in a half-space given
// in the rest pose of a bone. The plane moves with the bone. In the frame of
// the bone it is fixed and, half-spaces being convex, contains the straight
// path of each vertex during the step: no muscle passes through a bone between
// two states.
SeparatingPlane PlaneOfBone(const ContactStep& step,
                            int muscle,
                            int f,
                            int bone,
                            const HalfSpace& at_rest);

// Finds the planes between muscles and bones that may meet in a step. Most
// triangles near a bone hardly move as the bone sees it: those that have moved
// by less than PlaneSearchOptions::kept_slack since their planes were found
// keep them (ContactState::bone_planes); the planes of the others are found
// anew.
//
// `kept` receives the planes that the next step begins with. The order of the
// planes depends on the meshes only.
std::vector<SeparatingPlane> FindPlanesOfBones(const StepOptions& options,
                                               const ContactStep& step,
                                               KeptBonePlanes* kept);

}  // namespace musclewarp
