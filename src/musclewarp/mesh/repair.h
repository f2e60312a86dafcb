// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/mesh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct RepairOptions {};
struct RepairReport {};

// Makes a closed, outward oriented 2-manifold of what segmentation delivers.
Mesh RepairMesh(const TriangleSoup& soup,
                const std::string& name,
                const RepairOptions& options,
                RepairReport* report);

}  // namespace musclewarp
