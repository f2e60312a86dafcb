// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A 2-manifold triangle mesh in double precision, millimetres. Where only
// positions and triangles are needed, pass Points and Triangles instead.
using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

// Builds connectivity; vertex and face order are kept. Precondition (CHECKed):
// the soup is 2-manifold and consistently oriented, no face is degenerate.
Mesh MeshFromSoup(const TriangleSoup& soup);

TriangleSoup SoupFromMesh(const Mesh& mesh);

}  // namespace musclewarp
