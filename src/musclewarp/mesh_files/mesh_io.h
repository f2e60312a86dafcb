// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_files/mesh_parts.h"

namespace musclewarp {

// Reads and writes surface mesh files. The extension chooses the format (case
// does not matter):
//
//   extension  read                                written
//   .ply       ASCII, binary; float, double        binary, double
//   .obj       v and f                             ASCII, 17 digits
//   .off       ASCII, binary                       ASCII, 17 digits
//   .stl       ASCII, binary                       binary, float
//   .vtk       legacy polydata, ASCII and binary   binary, double
//   .vtp       XML polydata                        binary, double
//
// Every format but .stl keeps all bits of a soup that is written and read
// again. The readers return points and faces as the file has them: they merge
// nothing but the corners of an .stl with identical coordinates, and they split
// polygons into triangles. The format .vtp needs a build with
// MUSCLEWARP_WITH_VTK. An .obj file holds no counts, so one that was cut off
// between two faces cannot be told from a whole one.

// Reads a mesh: a file, or one of its named parts (mesh_path.h), of which only
// the points in use are kept. The result has at least one triangle, finite
// coordinates, and indices in range. Throws InputError if the file is missing,
// empty, truncated or not a mesh, if it has no face, if a coordinate is not
// finite, or if a face names a vertex that the file does not have. The message
// names the line, or the vertex or face, and for a part that is not there those
// that are. What the user has to know of how the file was read is appended to
// `notes`, and the named parts of what was read are set to `parts`, unless
// these are null.
TriangleSoup ReadTriangleSoup(const std::string& path,
                              std::vector<std::string>* notes = nullptr,
                              MeshParts* parts = nullptr);

// Writes a mesh; the file appears complete or not at all. Throws InputError if
// the folder cannot be written, the extension is not one of the above, or the
// range of the format (float for .stl) is too small for a coordinate.
// Precondition (CHECKed): the soup is sound, see TriangleSoup.
void WriteTriangleSoup(const std::string& path, const TriangleSoup& soup);

// True if this build reads and writes files with this extension, which may be
// given with or without the dot and in any case.
bool IsMeshExtension(const std::string& extension);

// Returns the extensions that this build reads, for messages: ".ply, .obj,
// ...".
std::string MeshFormats();

}  // namespace musclewarp
