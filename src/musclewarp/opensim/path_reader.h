// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// Returns the element <GeometryPath> or <FunctionBasedPath> of a muscle, or of
// another force of the <ForceSet> that has one. Returns an empty node if there
// is none.
pugi::xml_node GeometryPathOf(pugi::xml_node force);

// Reads the path of a force that has one: fixed, moving and conditional points,
// under the names of OpenSim 2 to 4. The model must have its bodies and
// coordinates. A point or function of an unknown kind is noted in
// ModelMuscle::unsupported. Throws InputError at the element if the path has
// fewer than two points, or if a point names an unknown body or coordinate or
// has an invalid number.
//
// The path of a <FunctionBasedPath> is its length function; as it has no
// points, it is also noted in ModelMuscle::unsupported.
ModelMuscle ReadPath(const OsimXml& xml,
                     const OffsetFrames& frames,
                     pugi::xml_node force,
                     const Model& model);

}  // namespace musclewarp
