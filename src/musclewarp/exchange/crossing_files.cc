// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/crossing_files.h"

#include <filesystem>
#include <sstream>

#include "musclewarp/base/csv_field.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/exchange/segment_files.h"
#include "musclewarp/mesh_files/mesh_io.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Adds triangles of a mesh; their corners are not shared.
void AppendTriangles(const SearchableMesh& mesh,
                     const std::vector<int>& triangles,
                     TriangleSoup* soup) {
  Eigen::Index corner = soup->points.rows();
  Eigen::Index row = soup->triangles.rows();
  const Eigen::Index count = static_cast<Eigen::Index>(triangles.size());
  soup->points.conservativeResize(corner + 3 * count, 3);
  soup->triangles.conservativeResize(row + count, 3);
  for (const int f : triangles) {
    soup->points.middleRows(corner, 3) = mesh.bvh().corners(f);
    for (int k = 0; k < 3; ++k) {
      soup->triangles(row, k) = static_cast<int>(corner++);
    }
    ++row;
  }
}

void AppendSegments(const SegmentSoup& more, SegmentSoup* curve) {
  const Eigen::Index points = curve->points.rows();
  const Eigen::Index segments = curve->segments.rows();
  curve->points.conservativeResize(points + more.points.rows(), 3);
  curve->points.bottomRows(more.points.rows()) = more.points;
  curve->segments.conservativeResize(segments + more.segments.rows(), 2);
  curve->segments.bottomRows(more.segments.rows()) =
      more.segments.array() + static_cast<int>(points);
}

}  // namespace

CrossingFiles::CrossingFiles(const std::string& dir, const std::string& format)
    : dir_(dir),
      format_(format),
      table_(
          "frame,a,b,x_mm,y_mm,z_mm,depth_mm,vertices_inside,triangles_of_a,"
          "triangles_of_b,curve_mm\n") {}

void CrossingFiles::Add(const std::string& label,
                        const std::vector<NamedMesh>& meshes,
                        const std::vector<CrossingPlace>& places) {
  TriangleSoup triangles;
  SegmentSoup curve;
  std::ostringstream lines;
  lines.precision(9);
  for (const CrossingPlace& place : places) {
    AppendTriangles(*meshes[place.a].mesh, place.triangles_of_a, &triangles);
    AppendTriangles(*meshes[place.b].mesh, place.triangles_of_b, &triangles);
    AppendSegments(place.curve, &curve);
    lines << CsvField(label) << ',' << CsvField(meshes[place.a].name) << ','
          << CsvField(meshes[place.b].name) << ',' << place.point[0] << ','
          << place.point[1] << ',' << place.point[2] << ',' << place.depth_mm
          << ',' << place.vertices_inside << ',' << place.triangles_of_a.size()
          << ',' << place.triangles_of_b.size() << ','
          << CurveLength(place.curve) << '\n';
  }
  table_ += lines.str();
  const auto path = [&](const std::string& what) {
    return (fs::path(dir_) / (label + "_" + what + "." + format_)).string();
  };
  if (triangles.triangles.rows() > 0) {
    WriteTriangleSoup(path("triangles"), triangles);
  }
  if (curve.segments.rows() > 0) WriteSegments(path("curves"), curve);
}

void CrossingFiles::WriteTable() const {
  WriteTextAtomically((fs::path(dir_) / "crossings.csv").string(), table_);
}

}  // namespace musclewarp
