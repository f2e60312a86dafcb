// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/surroundings.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Adds where a muscle with the mesh `fine` is attached to the other muscles of
// the scene on which it ends, `tied_to`: what of its tip lies on the surface of
// such a muscle or in it, as on bones (FindAttachments). Positions are those of
// the rest pose, mm.
void AddSoftAttachments(const TriangleSoup& fine,
                        const Surroundings& surroundings,
                        const Scene& scene,
                        const std::vector<int>& tied_to,
                        SceneMuscle* muscle);

// Gives the muscles of a scene what carries their attachments to soft parts.
// To be called whenever models have been prepared.
void AddSoftCarriers(PreparedScene* scene);

}  // namespace musclewarp
