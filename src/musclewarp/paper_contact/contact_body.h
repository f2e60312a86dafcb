// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/paper_contact/bounding_capsule.h"
#include "musclewarp/proximity/inside_test.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// What does not change about a mesh in contact while its points move: its
// connectivity, and the search structures of its rest pose. It is built once
// and shared by the bodies of all poses.
struct ContactShape {
  std::string name;
  Points rest;  // #V x 3, mm
  Triangles triangles;
  double bounding_radius = 0;   // of a sphere around the rest points, mm
  InsideTest rest_inside_test;  // of the rest points
  TriangleBvh rest_bvh;

  // `seed` chooses the directions of the rays of the inside test.
  ContactShape(std::string shape_name, TriangleSoup soup, unsigned seed);
};

// A mesh in contact at one moment. A muscle is deformable: its points may go
// anywhere. A bone is an obstacle: it has been moved rigidly and stays where it
// is.
//
// Queries about an obstacle are transformed to its rest pose and use the search
// structures of its shape. Those of a muscle are built when a query first needs
// them, and refitted after MoveTo; that is why a body must not be used from
// several threads at once.
class ContactBody {
 public:
  // Makes a muscle in its rest pose. Keeps a reference to the shape; `seed` as
  // in ContactShape.
  static ContactBody Deformable(const ContactShape& shape, unsigned seed);

  // Makes a bone that has been moved by `target_from_rest`, a rigid transform
  // with its translation in mm. Keeps a reference to the shape.
  static ContactBody Obstacle(const ContactShape& shape,
                              const Eigen::Matrix4d& target_from_rest);

  bool is_deformable() const { return is_deformable_; }
  const ContactShape& shape() const { return *shape_; }
  const Points& points() const { return points_; }  // #V x 3, mm

  // Replaces the points. Preconditions (CHECKed): the body is deformable, and
  // the number of points is that of the shape.
  void MoveTo(Points points);

  // Returns the indices, in rising order, of the `points` (#P x 3, mm) that lie
  // inside this body (paper section 3.2).
  std::vector<int> Inside(const Points& points) const;

  // Returns the distance from a point along a unit direction to the first
  // triangle, mm, or infinity if the ray meets none.
  double DistanceAlong(const Eigen::RowVector3d& point,
                       const Eigen::RowVector3d& direction) const;

  // Returns the point of the surface that is closest to a point.
  TriangleBvh::Closest Closest(const Eigen::RowVector3d& point) const;

  // Returns a capsule around the points. Bodies whose capsules do not overlap
  // cannot touch (paper section 3.3).
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
  // The transform of an obstacle; the identity for a muscle.
  Eigen::Matrix3d rest_from_target_rotation_ = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d target_translation_ = Eigen::RowVector3d::Zero();

  // Search structures of a muscle, at its present points unless stale.
  mutable std::unique_ptr<InsideTest> inside_test_;
  mutable bool is_inside_test_stale_ = true;
  mutable std::unique_ptr<TriangleBvh> bvh_;
  mutable bool is_bvh_stale_ = true;
  mutable std::optional<Capsule> capsule_;
};

}  // namespace musclewarp
