// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns where a muscle with the mesh `fine` is attached to the soft part
// `name` on which it ends: what of its tip lies on the surface of that part or
// in it, as on bones (FindAttachments). None if no tip is there. Positions are
// those of the rest pose, mm.
std::vector<Attachment> SoftAttachments(const TriangleSoup& fine,
                                        const std::vector<BodySurface>& bodies,
                                        const std::vector<ActionLine>& lines,
                                        const TriangleBvh& surface,
                                        const std::string& name);

// Gives the muscles of a scene what carries their attachments to soft parts.
// To be called whenever models have been prepared.
void AddSoftCarriers(PreparedScene* scene);

}  // namespace musclewarp
