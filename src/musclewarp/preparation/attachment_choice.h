// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Which areas of muscles follow their bodies.
enum class AttachmentKind {
  kAuto,   // those of the scene; found on the meshes for muscles without any
  kScene,  // those of the scene
  kNone,
};

// Returns the attachments of a muscle with the fine mesh `fine`: those of the
// scene or, if there are none and `kind` asks for it, those that are found on
// the meshes (FindAttachments). Lines that leave an attachment in some pose
// contradict it (FindLeavingLine): a found one is dropped then, as the meshes
// may mislead and the lines were meant; one of the scene stays. `warnings` gets
// a sentence for each.
std::vector<Attachment> ChooseAttachments(
    AttachmentKind kind,
    const SceneMuscle& muscle,
    const std::vector<ScenePose>& poses,
    const TriangleSoup& fine,
    const std::vector<BodySurface>& bodies,
    const std::vector<const TriangleBvh*>& soft_parts,
    std::vector<std::string>* warnings);

}  // namespace musclewarp
