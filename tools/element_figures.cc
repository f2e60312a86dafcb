// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/element_figures.h"

#include <iomanip>
#include <nlohmann/json.hpp>

#include "musclewarp/exchange/sharp_points.h"

namespace musclewarp {

using OrderedJson = nlohmann::ordered_json;

void AddElementFigures(const TetrahedralMesh& mesh,
                       const ElementQuality& quality,
                       Eigen::Index surface_points,
                       OrderedJson* record) {
  (*record)["tetrahedra"] = mesh.tetrahedra.rows();
  (*record)["points"] = mesh.points.rows();
  (*record)["points_inside"] = mesh.points.rows() - surface_points;
  (*record)["smallest_dihedral_deg"] = quality.smallest_dihedral_deg;
  (*record)["largest_dihedral_deg"] = quality.largest_dihedral_deg;
  (*record)["dihedrals_below_10_deg"] = quality.small_angles;
  (*record)["of_them_at_sharp_surface"] = quality.small_angles_at_sharp;
  (*record)["largest_aspect"] = quality.largest_aspect;
  (*record)["inverted"] = quality.inverted;
  (*record)["volume_mm3"] = quality.volume;
}

void PrintElementHeading(std::ostream& screen) {
  screen << "frame        tetrahedra  points inside  min dihedral  below "
         << kSmallDihedralDeg << "  aspect  seconds\n";
}

void PrintElementFigures(const OrderedJson& record, std::ostream& screen) {
  screen << std::setw(13) << record["tetrahedra"].get<int>() << std::setw(15)
         << record["points_inside"].get<int>() << std::fixed
         << std::setprecision(2) << std::setw(14)
         << record["smallest_dihedral_deg"].get<double>() << std::setw(10)
         << record["dihedrals_below_10_deg"].get<int>() << std::setprecision(1)
         << std::setw(8) << record["largest_aspect"].get<double>()
         << std::setw(9) << record["wall_ms"].get<double>() / 1e3;
}

void PrintSmallAngles(const std::map<std::string, OrderedJson>& records,
                      std::ostream& screen) {
  int small = 0, at_sharp = 0;
  for (const auto& [label, record] : records) {
    small += record.value("dihedrals_below_10_deg", 0);
    at_sharp += record.value("of_them_at_sharp_surface", 0);
  }
  if (small == 0) return;
  screen << std::defaultfloat << std::setprecision(6) << small
         << " tetrahedra have an angle below " << kSmallDihedralDeg
         << " degrees; at " << at_sharp
         << " of them the surface itself is sharp (edges below "
         << kSharpEdgeDeg << ", triangles below " << kSharpTriangleDeg
         << " degrees), which --element_size makes anew\n";
}

}  // namespace musclewarp
