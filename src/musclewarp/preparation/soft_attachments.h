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

// Returns the attachment of a muscle to the soft part `name`, on which it ends:
// the part of a detected end (FindAttachments) that lies on or inside
// `surface`, the surface of the soft part, with the tolerance for bones
// (kAreaDepth). The end nearest to the surface is chosen, and removed from
// `found`, so that no bone holds it. Returns nothing if there is no end.
// Positions are in the rest pose, mm.
std::optional<Attachment> TakeSoftAttachment(
    const TriangleBvh& surface,
    const std::string& name,
    std::vector<FoundAttachment>* found);

// Sets the carriers of the attachments to soft parts of all muscles. Must be
// called whenever models have been prepared.
void AddSoftCarriers(PreparedScene* scene);

// Returns the indices of all muscles in groups: what carries those of a group
// is in the groups before. Muscles that carry each other are together in the
// last one.
std::vector<std::vector<int>> CarriersFirst(const PreparedScene& scene);

}  // namespace musclewarp
