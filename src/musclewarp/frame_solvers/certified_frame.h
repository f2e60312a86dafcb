// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

// Returns the frame of a state in contact, measured and judged by the
// certificate: violated requirements are listed as its shortcomings. The caller
// adds times and moment arms. `before`: the fine meshes before the motion, as
// for MeasureFrame(); `summaries`: those of the solves; both in the order of
// the scene. `meshes`: the meshes of the scene, which are moved.
Frame CertifiedFrame(const PreparedScene& scene,
                     const CertifiedScene& certified,
                     const FrameRequirements& requirements,
                     const ContactState& state,
                     const std::vector<Points>& before,
                     std::vector<SolverSummary> summaries,
                     SceneMeshes* meshes,
                     const MeasureOptions& options = {});

// Returns the separated rest pose of a scene, tested and judged by the same
// requirements. `meshes`: the meshes of the scene, which are moved.
RestResult RestResultOf(const PreparedScene& scene,
                        CertifiedScene certified,
                        const FrameRequirements& requirements,
                        SceneMeshes* meshes);

}  // namespace musclewarp
