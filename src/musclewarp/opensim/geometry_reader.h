// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// The meshes a <Body> element of either version shows (VisibleObject,
// attached_geometry).
std::vector<ModelGeometry> ReadBodyGeometry(const OsimXml& xml,
                                            pugi::xml_node body);

// Adds those attached to offset frames to the bodies under them.
void AddOffsetGeometry(const OsimXml& xml,
                       const OffsetFrames& frames,
                       Model* model);

}  // namespace musclewarp
