// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/found_attachments.h"
#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The source of the attachment areas of muscles.
enum class AttachmentKind {
  kAuto,   // the scene, or detection on the meshes for muscles without any
  kScene,  // the scene
  kNone,
};

// Returns the attachments to bodies of a muscle with the fine mesh `fine`:
// those of the scene or, if it has none and `kind` is kAuto, those detected on
// the meshes (`found`, by FindAttachments). Detected tips that lie on other
// soft parts, or beyond which a line continues, and areas at the end of a
// tendon without a mesh are omitted, since the lines determine their motion. A
// line that leaves an attachment in some pose contradicts it (FindLeavingLine):
// a detected attachment is then dropped, because the lines are more reliable
// than the meshes; an attachment of the scene is kept. `warnings` is set to a
// sentence per contradiction. Lengths are in units of `body_size` mm
// (Scene::body_size).
std::vector<Attachment> ChooseAttachments(
    AttachmentKind kind,
    const SceneMuscle& muscle,
    const std::vector<ScenePose>& poses,
    const TriangleSoup& fine,
    const std::vector<FoundAttachment>& found,
    const std::vector<BodySurface>& bodies,
    const std::vector<const TriangleBvh*>& soft_parts,
    double body_size,
    std::vector<std::string>* warnings);

}  // namespace musclewarp
