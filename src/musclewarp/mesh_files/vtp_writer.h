// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Writes XML polydata (.vtp) for ParaView: binary, compressed, in double
// precision, and the same bytes for the same data. Only in builds with
// MUSCLEWARP_WITH_VTK.

// Values to colour a surface or lines by: at the points, #V x 1 or #V x 3, or
// at the lines, #lines x 1.
struct NamedField {
  std::string name;
  Eigen::MatrixXd values;
};

// Returns the file of a triangle mesh with fields at its points. Precondition
// (CHECKed): every field has a row for each point.
std::string VtpOfMesh(const TriangleSoup& soup,
                      const std::vector<NamedField>& point_data = {});

// Returns the file of polylines, each #P x 3 in mm, with fields at the lines;
// lines share no points. Precondition (CHECKed): every field has a row for each
// line.
std::string VtpOfLines(const std::vector<Points>& lines,
                       const std::vector<NamedField>& line_data);

}  // namespace musclewarp
