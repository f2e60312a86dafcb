// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// The path of a muscle (or of anything else of the ForceSet that has one); no
// element if it has none.
pugi::xml_node GeometryPathOf(pugi::xml_node force);

// Reads the points of a path. Throws InputError at the element.
ModelMuscle ReadPath(const OsimXml& xml,
                     const OffsetFrames& frames,
                     pugi::xml_node force,
                     const Model& model);

}  // namespace musclewarp
