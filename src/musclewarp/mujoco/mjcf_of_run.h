// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/exchange/fitted_paths.h"
#include "musclewarp/mujoco/mjcf_file.h"

namespace musclewarp {

// Makes the MuJoCo model of a run: the bodies and joints of its OpenSim model,
// the meshes of its bones, a tendon for each path that follows its function in
// the postures of the run, and the surface of each muscle as a skin that
// follows its frames, with slides where it is farther than `max_skin_distance`
// from them on the mean, mm (FitSlides). `dir` is the folder of the run;
// `paths` and `fitted` are of it (further runs may be among them).
// `on_progress` is told what is being fitted, and may be empty.
//
// Throws InputError that names the file and the field if the run is of an
// earlier version, which did not write how its meshes lie on the model
// (motion.rest in report.json), or has no frame with files.
MjcfModel MjcfOfRun(const std::string& dir,
                    const RunPaths& paths,
                    const FittedPaths& fitted,
                    double max_skin_distance,
                    const std::function<void(const std::string&)>& on_progress);

// The most frames to which paths and skins are fitted, evenly spread.
constexpr int kMostPathFrames = 120;
constexpr int kMostSkinFrames = 120;

}  // namespace musclewarp
