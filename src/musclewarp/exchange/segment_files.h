// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/exchange/crossing_places.h"

namespace musclewarp {

// Writes straight pieces of curves for other programs. The extension chooses
// the format: .ply (vertices and edges, binary, double precision: MeshLab),
// .obj (v and l, 17 digits: Blender), .vtp (lines: ParaView and 3D Slicer; in
// builds with MUSCLEWARP_WITH_VTK). The file appears complete or not at all.
// Throws InputError if the folder cannot be written. Precondition (CHECKed):
// the extension is one of these.
void WriteSegments(const std::string& path, const SegmentSoup& curve);

}  // namespace musclewarp
