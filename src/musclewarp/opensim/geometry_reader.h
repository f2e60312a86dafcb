// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// Returns the meshes that are attached to a body by its <Body> element, in
// either version of the format: <VisibleObject> of OpenSim 3 and
// <attached_geometry> of OpenSim 4. Other geometry, such as spheres, is
// ignored. Throws InputError at an element whose numbers are not valid.
std::vector<ModelGeometry> ReadBodyGeometry(const OsimXml& xml,
                                            pugi::xml_node body);

// Adds the meshes that are attached to offset frames to the bodies on which
// these frames sit. Throws InputError as ReadBodyGeometry does, and if a frame
// does not rest on a body.
void AddOffsetGeometry(const OsimXml& xml,
                       const OffsetFrames& frames,
                       Model* model);

}  // namespace musclewarp
