// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp::python {

// Meshes of Python do not change, so that arrays can show their numbers.
using SharedMesh = std::shared_ptr<const TriangleSoup>;

// Returns the mesh of anything that has `points` and `triangles`, or a `mesh`
// that has; without a copy if it is one of the package. Throws InputError,
// whose place is `where`, for anything else.
SharedMesh MeshFrom(const pybind11::handle& object, const std::string& where);

// Returns the mesh of arrays. Throws InputError for what is none.
std::shared_ptr<TriangleSoup> MeshOfArrays(const pybind11::object& points,
                                           const pybind11::object& triangles,
                                           const std::string& where);

}  // namespace musclewarp::python
