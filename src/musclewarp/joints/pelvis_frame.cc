// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/pelvis_frame.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

using HullKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hull = CGAL::Surface_mesh<HullKernel::Point_3>;

// A triangle whose first two corners are the ends of its longest side.
struct HullTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  double area = 0;

  Eigen::Vector3d LongSide() const { return corners[1] - corners[0]; }
};

HullTriangle TriangleOf(std::array<Eigen::Vector3d, 3> corners) {
  int longest = 0;
  for (int side = 1; side < 3; ++side) {
    const auto length = [&](int i) {
      return (corners[(i + 1) % 3] - corners[i]).norm();
    };
    if (length(side) > length(longest)) longest = side;
  }
  std::rotate(corners.begin(), corners.begin() + longest, corners.end());
  return {corners,
          (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2};
}

// Coplanar points, as at the border of an image, have a hull whose triangles
// depend on memory addresses in CGAL. All points are therefore perturbed
// slightly, by a low-discrepancy sequence.
std::vector<HullTriangle> TrianglesOfHull(const Points& points) {
  constexpr double kMost = 1e-6;  // mm, far below what a frame shows
  const Eigen::RowVector3d step(
      0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
  std::vector<HullKernel::Point_3> corners;
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d turns = (i + 1) * step;
    const Eigen::RowVector3d place =
        points.row(i) + kMost * (turns - turns.array().floor().matrix()).eval();
    corners.emplace_back(place.x(), place.y(), place.z());
  }
  Hull hull;
  CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
  std::vector<HullTriangle> triangles;
  for (const auto face : hull.faces()) {
    std::array<Eigen::Vector3d, 3> of_face;
    int next = 0;
    for (const auto vertex : hull.vertices_around_face(hull.halfedge(face))) {
      const auto& p = hull.point(vertex);
      of_face[next++] = {p.x(), p.y(), p.z()};
    }
    triangles.push_back(TriangleOf(of_face));
  }
  return triangles;
}

}  // namespace

std::optional<Eigen::Matrix3d> PelvisAxes(const Points& points,
                                          const Eigen::Vector3d& across) {
  std::vector<HullTriangle> triangles = TrianglesOfHull(points);
  if (triangles.size() < 4) return std::nullopt;
  std::sort(triangles.begin(), triangles.end(), [](auto& a, auto& b) {
    return a.area > b.area;
  });
  const auto along = [&](const HullTriangle& triangle) {
    return std::abs(triangle.LongSide().normalized().dot(across));
  };
  const bool is_second = triangles[1].area > kJointSearch.body.second_triangle *
                                                 triangles[0].area &&
                         along(triangles[1]) > along(triangles[0]);
  const HullTriangle& front = triangles[is_second ? 1 : 0];
  const Eigen::Vector3d middle = points.colwise().mean().transpose();
  const Eigen::Vector3d spines = (front.corners[0] + front.corners[1]) / 2;
  const Eigen::Vector3d side = front.LongSide().normalized();
  Eigen::Vector3d up = spines - front.corners[2];
  up = (up - up.dot(side) * side).normalized();
  Eigen::Vector3d forward = side.cross(up);
  // The pelvis lies behind the plane.
  if (forward.dot(middle - spines) > 0) forward = -forward;
  Eigen::Matrix3d axes;
  axes << forward, up, forward.cross(up);
  return axes;
}

bool IsOneHipBone(const Points& points, const Sphere& femoral_head) {
  const Eigen::Vector3d middle = points.colwise().mean().transpose();
  return (femoral_head.center - middle).norm() <
         kJointSearch.body.one_hip_bone * femoral_head.radius;
}

Points WithMirrorImage(const Points& hip_bone,
                       Side side,
                       const Eigen::Vector3d& right) {
  const Eigen::Vector3d outward = side == Side::kRight ? right : -right;
  const Eigen::VectorXd off_mirror =
      (hip_bone * outward).array() - (hip_bone * outward).minCoeff();
  Points both(2 * hip_bone.rows(), 3);
  both << hip_bone, hip_bone - 2 * off_mirror * outward.transpose();
  return both;
}

}  // namespace musclewarp
