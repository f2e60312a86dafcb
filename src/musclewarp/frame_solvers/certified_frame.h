// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

// Returns the frame of a state in contact, measured and judged by the
// certificate: what the frame does not hold of the requirements is among its
// shortcomings. Its times and moment arms are left to the caller. `before` are
// the fine meshes that the pose was reached from, as MeasureFrame() has them,
// and `summaries` those of the solves, both in the order of the scene. `meshes`
// are those of the scene and are moved.
Frame CertifiedFrame(const PreparedScene& scene,
                     const CertifiedScene& certified,
                     const FrameRequirements& requirements,
                     const ContactState& state,
                     const std::vector<Points>& before,
                     std::vector<SolverSummary> summaries,
                     SceneMeshes* meshes);

// Returns the muscles, by number, that contact has moved farther in the
// separated rest pose than the requirements allow. `intersections` are those of
// the rest pose. `meshes` are those of the scene and are moved.
std::vector<int> MusclesDisplacedAtRest(const PreparedScene& scene,
                                        const CertifiedScene& certified,
                                        const FrameRequirements& requirements,
                                        const SceneIntersections& intersections,
                                        SceneMeshes* meshes);

}  // namespace musclewarp
