// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/run/attachments_file.h"
#include "musclewarp/run/recorded_pose.h"

namespace musclewarp {

// The surfaces of a frame are made for other purposes than finite elements:
// those of bones are finer than contact needs, and the triangles of muscles are
// of the size and shape that segmentation gave them. The functions below
// replace them. Lengths are in mm.

// Simplifies bones where they are farther than `reach` from all muscles, so
// that no point moves by more than `tolerance`. The nearer triangles stay, and
// with them every gap up to `reach`, which must be above `tolerance` for
// muscles not to be met elsewhere. Returns the largest distance of a vertex to
// the new surface.
double CoarsenBones(double tolerance, double reach, RecordedPose* pose);

// Gives muscles triangles with edges of about `edge_length`
// (RemeshedWithoutCrossings), and moves them apart where they then cross each
// other or bones (SeparateInitially). Attachments go to the new vertices that
// are nearest to attached ones. `body_size`: Scene::body_size of the run.
// Returns the largest distance of an old vertex to the new surface of its
// muscle.
double RemeshMuscles(double edge_length,
                     double body_size,
                     const RecordedNames& names,
                     RecordedPose* pose,
                     RecordedAttachments* attachments);

}  // namespace musclewarp
