// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A 2-manifold triangle mesh with connectivity, in double precision and mm, for
// algorithms that collapse or flip edges (the removal of slivers, the
// simplification of meshes). Code that needs only positions and
// triangles takes Points and Triangles instead.
using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

// Builds the connectivity of a soup; vertices and faces keep their order.
// Precondition (CHECKed): the soup is 2-manifold and consistently oriented, and
// no face repeats a corner.
Mesh MeshFromSoup(const TriangleSoup& soup);

// Returns the points and triangles of a mesh in its order, each triangle
// starting with the corner it was added with, so that
// SoupFromMesh(MeshFromSoup(soup)) is `soup`. Precondition: no element is
// marked as deleted (collect the garbage first).
TriangleSoup SoupFromMesh(const Mesh& mesh);

}  // namespace musclewarp
