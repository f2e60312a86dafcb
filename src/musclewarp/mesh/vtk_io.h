// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Writing XML polydata (.vtp) through VTK; only in builds with
// MUSCLEWARP_WITH_VTK. Who includes this header links VTK::CommonDataModel.

// Points in double precision, triangles as polygons. Add point data to the
// result to have them written.
vtkSmartPointer<vtkPolyData> PolyDataFromSoup(const TriangleSoup& soup);

// The file: binary, compressed, the same bytes for the same data.
std::string VtpBytes(vtkPolyData* data);

}  // namespace musclewarp
