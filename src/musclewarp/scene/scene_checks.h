// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Checks what concerns several parts of a scene, or what a model may have
// brought into it, after all of it has been read:
//
// - Names can be written: those of muscles and bones as files, those of lines
//   as columns of tables, those of poses in reports (scene_names.h). Muscles
//   and bones have different names; so have lines, and so have poses.
// - Every coordinate is within kLargestCoordinate.
// - A line has at least two points, neighbours differ, and if it names bodies
//   there is one for each point. Targets have as many points as their line.
// - Bodies that lines and attachments follow belong to a bone, are moved by a
//   pose, or come from the model. A body needs no mesh.
// - The muscles on which a muscle ends are others of the scene; the bodies on
//   which it ends are two, and have bones.
// - Bodies that poses move are those of a bone, a line or an attachment.
//   They move rigidly (rigid_motion.h).
//
// Throws InputError naming the scene file, if there is one, and the place.
void CheckScene(const Scene& scene);

// Checks what of the above concerns one pose, which need not be one of those of
// the scene.
void CheckPose(const Scene& scene, const ScenePose& pose);

}  // namespace musclewarp
