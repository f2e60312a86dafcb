// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Checks the consistency of a scene after reading: references between its
// parts, and data taken from a model.
//
// - Names can be written: those of muscles and bones as file names, those of
//   lines as table columns, those of poses in reports (scene_names.h). The
//   names of muscles and bones are unique, and so are those of lines and those
//   of poses.
// - The absolute values of all coordinates are at most kLargestCoordinate.
// - A line has at least two points, and consecutive points differ. If it names
//   bodies, it names one for each point. Targets have as many points as their
//   line.
// - Bodies that lines and attachments follow belong to a bone, are moved by a
//   pose, or exist in the model. A body needs no mesh.
// - The muscles on which a muscle ends are other muscles of the scene. If it
//   names the bodies on which it ends, they are two and have bones.
// - Bodies that poses move belong to a bone, a line or an attachment. They move
//   rigidly (rigid_motion.h).
//
// Throws InputError naming the scene file, if there is one, and the part.
void CheckScene(const Scene& scene);

// Checks a pose in the same way. It need not be one of the scene's poses.
void CheckPose(const Scene& scene, const ScenePose& pose);

}  // namespace musclewarp
