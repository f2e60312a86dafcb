// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/scene/scene.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"

namespace musclewarp {

// A spindle along z, 120 mm long, 24 mm thick, between the bodies "pelvis" (at
// -z) and "femur", with one line through its middle, a second along its side
// and an attachment area at each end.
SceneMuscle SpindleMuscle();

// Three fibres of it, from origin to insertion.
std::vector<Points> SpindleFibres();

// Options without rows for attachments, as in the paper.
MuscleModelOptions NoAttachmentRows();

// The same, prepared: 642 fine vertices in a hull of 162.
MuscleModel SpindleModel(
    const MuscleModelOptions& options = NoAttachmentRows());

// The minimum of a target, within 1e-9 mm.
Points SolvedTightly(const MuscleModel& model, const MuscleTarget& target);

// A pose in which the femur has moved by rotation and then translation.
ScenePose FemurPose(const Eigen::Matrix3d& rotation,
                    const Eigen::Vector3d& translation);

// The femur bent about an axis across the muscle, near its middle.
ScenePose BentPose(double angle);

// A pose in which both bodies have moved the same way.
ScenePose RigidPose(const Eigen::Matrix3d& rotation,
                    const Eigen::Vector3d& translation);

}  // namespace musclewarp
