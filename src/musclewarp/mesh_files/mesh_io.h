// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Surface mesh files, chosen by extension (case does not matter):
//
//   extension  read                                written
//   .ply       ASCII, binary; float, double        binary, double
//   .obj       v and f                             ASCII, 17 digits
//   .off       ASCII                               ASCII, 17 digits
//   .stl       ASCII, binary                       binary, float
//   .vtk       legacy polydata, ASCII and binary   binary, double
//   .vtp       XML polydata                        binary, double
//
// Points come back as the file has them: nothing is merged but the corners of
// an .stl with identical coordinates, and polygons are split into triangles.
// .vtp needs a build with MUSCLEWARP_WITH_VTK. An .obj holds no counts, so one
// cut short between two faces cannot be told from a whole one.

// Throws InputError if the file is missing, empty, truncated or not a mesh, if
// it has no face, a coordinate that is not finite, or a face that names a
// vertex that is not there.
TriangleSoup ReadTriangleSoup(const std::string& path);

// Appears complete or not at all. Throws InputError if the folder cannot be
// written or the extension is not one of the above.
void WriteTriangleSoup(const std::string& path, const TriangleSoup& soup);

// True if `extension` (with or without dot, any case) is one this build writes.
bool IsMeshExtension(const std::string& extension);

}  // namespace musclewarp
