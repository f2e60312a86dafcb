// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/format_checks.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "support/meshes.h"

namespace musclewarp {

TriangleSoup HardSoup() {
  TriangleSoup soup = Icosphere(100, 1);
  soup.points += RandomPoints(static_cast<int>(soup.points.rows()), 7);
  soup.points.row(0) << 0.1, 1.0 / 3, -2.0 / 3;
  soup.points.row(1) << 4.9406564584124654e-324, -2.2250738585072009e-308,
      1.7976931348623157e308;
  soup.points.row(2) << 0.0, -0.0, 123456789.12345679;
  soup.points.row(3) = soup.points.row(4);
  soup.points.conservativeResize(soup.points.rows() + 1, 3);
  soup.points.bottomRows(1) << 1, 2, 3;
  soup.triangles.row(0) << 5, 5, 6;
  return soup;
}

bool SameBits(const TriangleSoup& a, const TriangleSoup& b) {
  return a.points.rows() == b.points.rows() &&
         a.triangles.rows() == b.triangles.rows() &&
         std::memcmp(a.points.data(),
                     b.points.data(),
                     a.points.size() * sizeof(double)) == 0 &&
         (a.triangles.array() == b.triangles.array()).all();
}

std::string TextOf(const Triangles& triangles) {
  std::ostringstream text;
  const Eigen::IOFormat format(
      Eigen::StreamPrecision, Eigen::DontAlignCols, " ", " ");
  text << triangles.format(format);
  return text.str();
}

std::string With(std::string text,
                 const std::string& old_part,
                 const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

}  // namespace musclewarp
