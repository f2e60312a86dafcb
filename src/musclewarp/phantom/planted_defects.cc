// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/planted_defects.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <random>
#include <set>
#include <vector>

#include "musclewarp/phantom/polygonize.h"

namespace musclewarp {
namespace {

constexpr double kSpacing = 10;       // mm between two places
constexpr double kFlapHeight = 1.5;   // mm
constexpr double kStrayDistance = 6;  // mm from the surface
constexpr double kStrayRadius = 1.5;  // mm

class Planter {
 public:
  Planter(const TriangleSoup& surface, uint32_t seed)
      : surface_(surface), random_(seed) {
    for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
      points_.push_back(surface.points.row(i).transpose());
    }
    for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
      triangles_.push_back(surface.triangles.row(f));
    }
  }

  void DuplicatePoint() {
    const int f = NextPlace();
    triangles_[f][0] = AddPoint(points_[triangles_[f][0]]);
  }

  void AddDegenerateTriangle() {
    const Eigen::RowVector3i t = triangles_[NextPlace()];
    triangles_.emplace_back(t[0], t[1], t[1]);
  }

  void AddFlap() {
    const int f = NextPlace();
    const Eigen::RowVector3i t = triangles_[f];
    const Eigen::Vector3d middle = 0.5 * (points_[t[0]] + points_[t[1]]);
    const int top =
        AddPoint(phantom::RoundedPoint(middle + kFlapHeight * Normal(f)));
    triangles_.emplace_back(t[0], t[1], top);
  }

  void AddStrayPiece() {
    const int f = NextPlace();
    const Eigen::Vector3d centre =
        phantom::RoundedPoint(Centre(f) + kStrayDistance * Normal(f));
    // An octahedron: corners 2 i and 2 i + 1 on axis i.
    const int first = points_.size();
    for (int corner = 0; corner < 6; ++corner) {
      const double radius = corner % 2 ? -kStrayRadius : kStrayRadius;
      AddPoint(centre + radius * Eigen::Vector3d::Unit(corner / 2));
    }
    for (int octant = 0; octant < 8; ++octant) {
      const int x = first + (octant & 1);
      const int y = first + 2 + ((octant >> 1) & 1);
      const int z = first + 4 + ((octant >> 2) & 1);
      const bool is_mirrored =
          ((octant & 1) + ((octant >> 1) & 1) + ((octant >> 2) & 1)) % 2;
      triangles_.emplace_back(x, is_mirrored ? z : y, is_mirrored ? y : z);
    }
  }

  void RemoveTriangle() { removed_.insert(NextPlace()); }

  TriangleSoup Result() const {
    TriangleSoup soup;
    soup.points.resize(points_.size(), 3);
    for (size_t i = 0; i < points_.size(); ++i) {
      soup.points.row(i) = points_[i].transpose();
    }
    soup.triangles.resize(triangles_.size() - removed_.size(), 3);
    int row = 0;
    for (size_t f = 0; f < triangles_.size(); ++f) {
      if (!removed_.count(f)) soup.triangles.row(row++) = triangles_[f];
    }
    return soup;
  }

 private:
  // Returns a triangle of the surface that is away from all earlier places.
  int NextPlace() {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const int f = random_() % surface_.triangles.rows();
      const Eigen::Vector3d centre = Centre(f);
      bool is_free = true;
      for (const Eigen::Vector3d& other : places_) {
        is_free = is_free && (centre - other).norm() >= kSpacing;
      }
      if (!is_free) continue;
      places_.push_back(centre);
      return f;
    }
    LOG(FATAL) << "no room for " << places_.size() + 1 << " defects "
               << kSpacing << " mm apart";
    return 0;
  }

  Eigen::Vector3d Corner(int f, int k) const {
    return surface_.points.row(surface_.triangles(f, k)).transpose();
  }

  Eigen::Vector3d Centre(int f) const {
    return (Corner(f, 0) + Corner(f, 1) + Corner(f, 2)) / 3;
  }

  Eigen::Vector3d Normal(int f) const {
    return (Corner(f, 1) - Corner(f, 0))
        .cross(Corner(f, 2) - Corner(f, 0))
        .normalized();
  }

  int AddPoint(const Eigen::Vector3d& p) {
    points_.push_back(p);
    return points_.size() - 1;
  }

  const TriangleSoup& surface_;
  std::mt19937 random_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::RowVector3i> triangles_;
  std::vector<Eigen::Vector3d> places_;
  std::set<size_t> removed_;
};

}  // namespace

TriangleSoup PlantDefects(const TriangleSoup& surface,
                          const PlantedDefects& defects,
                          uint32_t seed) {
  Planter planter(surface, seed);
  for (int i = 0; i < defects.duplicate_points; ++i) planter.DuplicatePoint();
  for (int i = 0; i < defects.degenerate_triangles; ++i) {
    planter.AddDegenerateTriangle();
  }
  for (int i = 0; i < defects.flaps; ++i) planter.AddFlap();
  for (int i = 0; i < defects.stray_pieces; ++i) planter.AddStrayPiece();
  for (int i = 0; i < defects.missing_triangles; ++i) planter.RemoveTriangle();
  return planter.Result();
}

}  // namespace musclewarp
