// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_files/mesh_parts.h"

namespace musclewarp {

// Reads a Wavefront OBJ file. `bytes` is the whole file, `path` is used in
// messages only; see mesh_io.h for what all readers promise and throw. The
// statements v (vertex) and f (face; fo in old files) are read, the others are
// skipped but for the names of parts, and a note counts those that the format
// does not have. Of the corners "v/vt/vn" of a face only v counts; negative
// indices count back from the last vertex before the face. The format holds no
// counts: a file that was cut off between two faces cannot be told from a whole
// one.
//
// `parts`, unless null, is set to the objects (o), or to the groups (g) if
// there is no object; all that follows on the line is the name. A group that is
// named again goes on, and an object that is named again is another one. Faces
// before the first belong to "default".
TriangleSoup ReadObj(const std::string& path,
                     std::string_view bytes,
                     std::vector<std::string>* notes,
                     MeshParts* parts = nullptr);

// Returns the text of an OBJ file of v and f statements. Coordinates have 17
// digits, from which the same doubles are read again.
std::string ObjBytes(const TriangleSoup& soup);

}  // namespace musclewarp
