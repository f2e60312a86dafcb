// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// XML polydata (.vtp) through VTK; only in builds with MUSCLEWARP_WITH_VTK. Who
// includes this header links VTK::CommonDataModel. The readers and writers here
// catch VTK's messages by replacing its output window while they run.

// Points in double precision, triangles as polygons. Add point data to the
// result to have them written.
vtkSmartPointer<vtkPolyData> PolyDataFromSoup(const TriangleSoup& soup);

// Polygons and triangle strips; vertices and lines are skipped. Throws
// InputError, naming `path`, as ReadTriangleSoup in mesh_io.h does.
TriangleSoup SoupFromPolyData(const std::string& path, vtkPolyData* data);

// `path` is for messages, `bytes` is the whole file.
TriangleSoup ReadVtp(const std::string& path, std::string_view bytes);

// The file: binary, compressed, the same bytes for the same data.
std::string VtpBytes(vtkPolyData* data);

}  // namespace musclewarp
