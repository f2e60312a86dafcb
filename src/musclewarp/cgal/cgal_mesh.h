// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The mesh type in which algorithms of CGAL take and return surfaces. This
// header is for the sources that call CGAL alone, as it takes long to compile.
using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

// Returns a copy of a mesh with the same numbers of vertices and triangles.
// Precondition (CHECKed): it is an oriented manifold without duplicate
// triangles.
CgalMesh ToCgalMesh(const TriangleSoup& soup);

// Returns a copy of a mesh without removed elements. Vertices and triangles
// that are left keep their order.
TriangleSoup FromCgalMesh(const CgalMesh& mesh);

}  // namespace musclewarp
