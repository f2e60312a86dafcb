// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/geometry/bounding_capsule.h"
#include "musclewarp/geometry/inside_test.h"
#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What of a mesh in contact does not change with its points.
struct ContactShape {
  std::string name;
  Points rest;  // #V x 3, mm
  Triangles triangles;
  double bounding_radius = 0;   // of a sphere around the rest points, mm
  InsideTest rest_inside_test;  // of the rest points
  TriangleBvh rest_bvh;

  ContactShape(std::string shape_name, TriangleSoup soup, unsigned seed);
};

// A mesh in contact at one moment: a muscle, whose points may go anywhere, or a
// bone, an obstacle that moves rigidly. Not for use from several threads, as
// what queries need is made when they first ask.
class ContactBody {
 public:
  // Keeps a reference to the shape.
  static ContactBody Deformable(const ContactShape& shape, unsigned seed);
  static ContactBody Obstacle(const ContactShape& shape,
                              const Eigen::Matrix4d& target_from_rest);

  bool is_deformable() const { return is_deformable_; }
  const ContactShape& shape() const { return *shape_; }
  const Points& points() const { return points_; }

  // Precondition (CHECKed): deformable, same number of points.
  void MoveTo(Points points);

  // The indices of `points` that are inside this body, rising.
  std::vector<int> Inside(const Points& points) const;

  // From a point the way along a unit direction to the first triangle, mm;
  // infinite if there is none.
  double DistanceAlong(const Eigen::RowVector3d& point,
                       const Eigen::RowVector3d& direction) const;

  // The point of the surface closest to a point.
  TriangleBvh::Closest Closest(const Eigen::RowVector3d& point) const;

  const Capsule& capsule() const;

 private:
  ContactBody(const ContactShape& shape, bool is_deformable, unsigned seed);
  const InsideTest& inside_test() const;
  const TriangleBvh& bvh() const;
  Eigen::RowVector3d RestFromTarget(const Eigen::RowVector3d& point) const;

  const ContactShape* shape_;
  bool is_deformable_;
  unsigned seed_;
  Points points_;
  // An obstacle is asked in its rest pose, so that its grid is built once.
  Eigen::Matrix3d rest_from_target_rotation_ = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d target_translation_ = Eigen::RowVector3d::Zero();

  mutable std::unique_ptr<InsideTest> inside_test_;  // of a moved muscle
  mutable bool is_inside_test_stale_ = true;
  mutable std::unique_ptr<TriangleBvh> bvh_;
  mutable bool is_bvh_stale_ = true;
  mutable std::optional<Capsule> capsule_;
};

}  // namespace musclewarp
