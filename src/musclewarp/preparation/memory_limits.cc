// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/memory_limits.h"

#include <cmath>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

constexpr double kMostPoints = 3e8;
constexpr double kMostPairs = 1e9;

double LatticePoints(const Box3& box, double spacing) {
  double points = 1;
  for (int k = 0; k < 3; ++k) {
    points *= (box.upper[k] - box.lower[k]) / spacing + 5;
  }
  return points;
}

}  // namespace

void CheckLatticeFits(const std::string& name,
                      const Box3& box,
                      double spacing) {
  if (LatticeFits(box, spacing)) return;
  std::ostringstream problem;
  problem << "needs ";
  for (int k = 0; k < 3; ++k) {
    problem << (k > 0 ? " x " : "")
            << std::round((box.upper[k] - box.lower[k]) / spacing);
  }
  problem << " samples, " << LatticePoints(box, spacing)
          << " in all; allowed: " << kMostPoints;
  throw InputError(name, problem.str(), "check its unit, or divide it");
}

bool LatticeFits(const Box3& box, double spacing) {
  return LatticePoints(box, spacing) <= kMostPoints;
}

void CheckContactFits(const std::vector<NamedMesh>& muscles,
                      double voxel_size,
                      double reach) {
  for (const NamedMesh& muscle : muscles) {
    const SearchableMesh& mesh = *muscle.mesh;
    CheckLatticeFits(muscle.name, mesh.bvh().box(), voxel_size);
    const auto triangles = static_cast<double>(mesh.triangles().rows());
    const double area = SurfaceArea(mesh.points(), mesh.triangles());
    // The expected number of triangles within `reach` of each triangle.
    const double pairs = triangles * M_PI * reach * reach * triangles / area;
    if (pairs <= kMostPairs) continue;
    std::ostringstream problem;
    problem.precision(3);
    problem << "has " << mesh.triangles().rows()
            << " triangles, of which contact would have to look at " << pairs
            << " pairs; allowed: " << kMostPairs;
    throw InputError(muscle.name,
                     problem.str(),
                     "check its unit, or make its triangles larger");
  }
}

}  // namespace musclewarp
