// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// These functions add a joint and its coordinates to a model that already has
// its bodies. Joints of an unknown type are added with a reason in
// Joint::unsupported, and so is the first joint of a body that has two, which
// is a closed loop. Both functions throw InputError at the element if it names
// an unknown body, frame or coordinate, if a coordinate exists already, or if
// an axis or a function is not valid.

// Adds the joint of an OpenSim 3 file, in which a joint is part of its child
// body. `child` is the index of that body.
void AddJointOfBody(const OsimXml& xml,
                    pugi::xml_node joint,
                    int child,
                    Model* model);

// Adds a joint of the <JointSet> of an OpenSim 4 file, in which a joint refers
// to frames on both bodies.
void AddJointOfSet(const OsimXml& xml,
                   const OffsetFrames& frames,
                   pugi::xml_node joint,
                   Model* model);

}  // namespace musclewarp
