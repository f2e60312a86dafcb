// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/surface_comparison.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/base/option_check.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/inside_test.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// A body to measure distances from.
class Body {
 public:
  explicit Body(const TriangleSoup& mesh)
      : surface_(mesh.points, mesh.triangles),
        inside_(mesh.points, mesh.triangles, /*seed=*/1) {}

  bool Contains(const RowVector3d& point) const {
    return inside_.Contains(point);
  }

  double SignedDistance(const RowVector3d& point) const {
    const double distance = surface_.ClosestPoint(point).distance;
    return Contains(point) ? -distance : distance;
  }

 private:
  TriangleBvh surface_;
  InsideTest inside_;
};

// Places on a surface, each of which stands for some area.
struct Samples {
  Points places;                     // #S x 3, mm
  Eigen::VectorXd areas;             // #S, mm^2
  Eigen::VectorXd signed_distances;  // #S, mm
};

// Returns into how many parts the edges of a triangle are cut.
double NumParts(const RowVector3d& a,
                const RowVector3d& b,
                const RowVector3d& c,
                double spacing) {
  const double longest =
      std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return std::max(1.0, std::ceil(longest / spacing));
}

// Cuts every triangle into equal ones whose edges are at most `spacing` long,
// and takes their centres.
Samples SampleSurface(const TriangleSoup& mesh, double spacing) {
  std::vector<RowVector3d> places;
  std::vector<double> areas;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const RowVector3d a = mesh.points.row(mesh.triangles(f, 0));
    const RowVector3d b = mesh.points.row(mesh.triangles(f, 1));
    const RowVector3d c = mesh.points.row(mesh.triangles(f, 2));
    const int parts = static_cast<int>(NumParts(a, b, c, spacing));
    const double area = (b - a).cross(c - a).norm() / 2 / (parts * parts);
    const auto add = [&](double u, double v) {
      places.push_back(a + u / parts * (b - a) + v / parts * (c - a));
      areas.push_back(area);
    };
    for (int i = 0; i < parts; ++i) {
      for (int k = 0; i + k < parts; ++k) {
        add(i + 1.0 / 3, k + 1.0 / 3);
        if (i + k + 1 < parts) add(i + 2.0 / 3, k + 2.0 / 3);
      }
    }
  }
  Samples samples;
  samples.places.resize(places.size(), 3);
  samples.areas.resize(areas.size());
  for (size_t i = 0; i < places.size(); ++i) {
    samples.places.row(i) = places[i];
    samples.areas[i] = areas[i];
  }
  return samples;
}

Eigen::VectorXd SignedDistances(const Body& body, const Points& points) {
  Eigen::VectorXd distances(points.rows());
#pragma omp parallel for schedule(dynamic, 256)
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    distances[i] = body.SignedDistance(points.row(i));
  }
  return distances;
}

SurfaceDistances DistancesOf(const Samples& samples) {
  const double area = samples.areas.sum();
  const Eigen::VectorXd distances = samples.signed_distances.cwiseAbs();
  SurfaceDistances result;
  result.mean = samples.areas.dot(distances) / area;
  result.root_mean_square =
      std::sqrt(samples.areas.dot(distances.cwiseAbs2()) / area);
  result.signed_mean = samples.areas.dot(samples.signed_distances) / area;
  result.largest = distances.maxCoeff();
  std::vector<Eigen::Index> order(distances.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index k) {
    return distances[i] < distances[k];
  });
  double below = 0;
  for (const Eigen::Index i : order) {
    below += samples.areas[i];
    result.percentile_95 = distances[i];
    if (below >= 0.95 * area) break;
  }
  return result;
}

Samples Together(const Samples& a, const Samples& b) {
  Samples both;
  both.areas.resize(a.areas.size() + b.areas.size());
  both.areas << a.areas, b.areas;
  both.signed_distances.resize(both.areas.size());
  both.signed_distances << a.signed_distances, b.signed_distances;
  return both;
}

struct Counts {
  long in_body = 0, in_both = 0;
};

// Counts the points of a regular grid, one of which is `origin`, in the box of
// a mesh that are in its body, and those that are in another one, too.
Counts CountPoints(const Points& mesh,
                   const Body& body,
                   const Body& other,
                   const RowVector3d& origin,
                   double spacing) {
  const auto cell = [&](const RowVector3d& point) -> Eigen::Array3i {
    return ((point - origin) / spacing).array().floor().cast<int>().transpose();
  };
  const Eigen::Array3i first = cell(mesh.colwise().minCoeff());
  const Eigen::Array3i last = cell(mesh.colwise().maxCoeff());
  long in_body = 0, in_both = 0;
#pragma omp parallel for reduction(+ : in_body, in_both) schedule(dynamic, 1)
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int x = first[0]; x <= last[0]; ++x) {
        const RowVector3d point = origin + spacing * RowVector3d(x, y, z);
        if (!body.Contains(point)) continue;
        ++in_body;
        in_both += other.Contains(point);
      }
    }
  }
  return {in_body, in_both};
}

}  // namespace

bool SurfaceComparisonOptions::IsValid(std::string* error) const {
  return OptionCheck("SurfaceComparisonOptions", error)
      .IsAtLeast("spacing", spacing, 0)
      .IsAtLeast("grid_points", grid_points, 1)
      .is_valid();
}

double NumSamples(const TriangleSoup& mesh, double spacing) {
  double count = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const double parts = NumParts(mesh.points.row(mesh.triangles(f, 0)),
                                  mesh.points.row(mesh.triangles(f, 1)),
                                  mesh.points.row(mesh.triangles(f, 2)),
                                  spacing);
    count += parts * parts;
  }
  return count;
}

SurfaceComparison CompareSurfaces(const TriangleSoup& a,
                                  const TriangleSoup& b,
                                  const SurfaceComparisonOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_GT(a.triangles.rows(), 0);
  CHECK_GT(b.triangles.rows(), 0);
  const RowVector3d lower =
      a.points.colwise().minCoeff().cwiseMin(b.points.colwise().minCoeff());
  const RowVector3d upper =
      a.points.colwise().maxCoeff().cwiseMax(b.points.colwise().maxCoeff());
  const Body body_a(a), body_b(b);
  SurfaceComparison result;
  result.spacing =
      options.spacing > 0 ? options.spacing : (upper - lower).norm() / 300;
  Samples of_a = SampleSurface(a, result.spacing);
  Samples of_b = SampleSurface(b, result.spacing);
  of_a.signed_distances = SignedDistances(body_b, of_a.places);
  of_b.signed_distances = SignedDistances(body_a, of_b.places);
  result.a_to_b = DistancesOf(of_a);
  result.b_to_a = DistancesOf(of_b);
  result.symmetric = DistancesOf(Together(of_a, of_b));
  result.vertex_distances = SignedDistances(body_b, a.points);

  result.volume_a = SignedVolume(a.points, a.triangles);
  result.volume_b = SignedVolume(b.points, b.triangles);
  result.grid_spacing = std::cbrt(std::max(result.volume_a, result.volume_b) /
                                  options.grid_points);
  const RowVector3d origin = lower.array() - result.grid_spacing / 2;
  const Counts in_a =
      CountPoints(a.points, body_a, body_b, origin, result.grid_spacing);
  const Counts in_b =
      CountPoints(b.points, body_b, body_a, origin, result.grid_spacing);
  const auto sum = static_cast<double>(in_a.in_body + in_b.in_body);
  const auto both = static_cast<double>(in_a.in_both);
  if (sum > 0) {
    result.dice = 2 * both / sum;
    result.jaccard = both / (sum - both);
  }
  return result;
}

}  // namespace musclewarp
