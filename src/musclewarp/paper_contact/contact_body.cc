// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/contact_body.h"

#include <glog/logging.h>

#include <utility>

namespace musclewarp {
namespace {

// Returns the radius of a sphere about the middle of the bounding box, mm.
double BoundingRadius(const Points& points) {
  if (points.rows() == 0) return 0;
  const Eigen::RowVector3d centre =
      0.5 * (points.colwise().minCoeff() + points.colwise().maxCoeff());
  return (points.rowwise() - centre).rowwise().norm().maxCoeff();
}

}  // namespace

ContactShape::ContactShape(std::string shape_name,
                           TriangleSoup soup,
                           unsigned seed)
    : name(std::move(shape_name)),
      rest(std::move(soup.points)),
      triangles(std::move(soup.triangles)),
      bounding_radius(BoundingRadius(rest)),
      rest_inside_test(rest, triangles, seed),
      rest_bvh(rest, triangles) {}

ContactBody::ContactBody(const ContactShape& shape,
                         bool is_deformable,
                         unsigned seed)
    : shape_(&shape),
      is_deformable_(is_deformable),
      seed_(seed),
      points_(shape.rest) {}

ContactBody ContactBody::Deformable(const ContactShape& shape, unsigned seed) {
  return ContactBody(shape, true, seed);
}

ContactBody ContactBody::Obstacle(const ContactShape& shape,
                                  const Eigen::Matrix4d& target_from_rest) {
  ContactBody body(shape, false, 0);
  const Eigen::Matrix3d rotation = target_from_rest.topLeftCorner<3, 3>();
  body.rest_from_target_rotation_ = rotation.transpose();
  body.target_translation_ = target_from_rest.topRightCorner<3, 1>();
  body.points_ =
      (shape.rest * rotation.transpose()).rowwise() + body.target_translation_;
  return body;
}

void ContactBody::MoveTo(Points points) {
  CHECK(is_deformable_) << shape_->name;
  CHECK_EQ(points.rows(), shape_->rest.rows());
  points_ = std::move(points);
  is_inside_test_stale_ = true;
  is_bvh_stale_ = true;
  capsule_.reset();
}

std::vector<int> ContactBody::Inside(const Points& points) const {
  const InsideTest& test = inside_test();
  const int count = static_cast<int>(points.rows());
  std::vector<char> is_inside(count, 0);
#pragma omp parallel for schedule(dynamic, 256)
  for (int i = 0; i < count; ++i) {
    is_inside[i] = test.Contains(RestFromTarget(points.row(i)));
  }
  std::vector<int> inside;
  for (int i = 0; i < count; ++i) {
    if (is_inside[i]) inside.push_back(i);
  }
  return inside;
}

double ContactBody::DistanceAlong(const Eigen::RowVector3d& point,
                                  const Eigen::RowVector3d& direction) const {
  return inside_test().DistanceAlong(
      RestFromTarget(point),
      direction * rest_from_target_rotation_.transpose());
}

TriangleBvh::Closest ContactBody::Closest(
    const Eigen::RowVector3d& point) const {
  TriangleBvh::Closest closest = bvh().ClosestPoint(RestFromTarget(point));
  closest.point =
      closest.point * rest_from_target_rotation_ + target_translation_;
  return closest;
}

const Capsule& ContactBody::capsule() const {
  if (!capsule_) capsule_ = BoundingCapsule(points_);
  return *capsule_;
}

const InsideTest& ContactBody::inside_test() const {
  if (!is_deformable_) return shape_->rest_inside_test;
  if (!inside_test_) {
    inside_test_ =
        std::make_unique<InsideTest>(points_, shape_->triangles, seed_);
  } else if (is_inside_test_stale_) {
    inside_test_->Refit(points_);
  }
  is_inside_test_stale_ = false;
  return *inside_test_;
}

const TriangleBvh& ContactBody::bvh() const {
  if (!is_deformable_) return shape_->rest_bvh;
  if (!bvh_) bvh_ = std::make_unique<TriangleBvh>(shape_->rest_bvh);
  if (is_bvh_stale_) bvh_->Refit(points_);
  is_bvh_stale_ = false;
  return *bvh_;
}

Eigen::RowVector3d ContactBody::RestFromTarget(
    const Eigen::RowVector3d& point) const {
  return (point - target_translation_) * rest_from_target_rotation_.transpose();
}

}  // namespace musclewarp
