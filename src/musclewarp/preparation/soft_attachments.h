// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/fibres/found_attachments.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns where a muscle is attached to the soft part `name` on which it ends:
// what of the end nearest to the surface of that part, out of those that were
// found (FindAttachments), lies on the surface or in it, as on bones. The end
// is removed from `found`, so that no bone holds it. Nothing if there is no
// end. Positions are those of the rest pose, mm.
std::optional<Attachment> TakeSoftAttachment(
    const TriangleBvh& surface,
    const std::string& name,
    std::vector<FoundAttachment>* found);

// Gives the muscles of a scene what carries their attachments to soft parts.
// To be called whenever models have been prepared.
void AddSoftCarriers(PreparedScene* scene);

}  // namespace musclewarp
