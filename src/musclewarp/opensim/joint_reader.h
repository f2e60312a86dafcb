// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// Adds a joint and its coordinates to the model, whose bodies are there.
// OpenSim 3 keeps it in the body that is its child, OpenSim 4 in a set of its
// own with frames on both bodies. Throw InputError at the element.
void AddJointOfBody(const OsimXml& xml,
                    pugi::xml_node joint,
                    int child,
                    Model* model);
void AddJointOfSet(const OsimXml& xml,
                   const OffsetFrames& frames,
                   pugi::xml_node joint,
                   Model* model);

}  // namespace musclewarp
