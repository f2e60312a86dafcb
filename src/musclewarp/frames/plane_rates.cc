// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/plane_rates.h"

#include "musclewarp/mesh/triangle.h"
#include "musclewarp/scene/perturbed_poses.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::RowVector3d;

// The motion of a triangle as that of a rigid body, and whether it turns: one
// without area does not.
struct TriangleRate {
  Matrix4d rate = Matrix4d::Zero();
  bool turns = false;
};

// The place of a triangle as contact has it (contact_step.cc): its centre, its
// first edge and its normal.
Matrix4d PlaceOfTriangle(const Corners& t, bool turns) {
  Matrix4d place = Matrix4d::Identity();
  place.topRightCorner<3, 1>() = t.colwise().mean().transpose();
  if (!turns) return place;
  const RowVector3d edge = (t.row(1) - t.row(0)).normalized();
  const RowVector3d normal = AreaVector(t).normalized();
  place.topLeftCorner<3, 3>() << edge.transpose(), normal.transpose(),
      edge.cross(normal).transpose();
  return place;
}

TriangleRate RateOfTriangle(const MuscleCarrier& muscle,
                            const Eigen::RowVector3i& triangle) {
  const Corners corners = CornersOf(*muscle.points, triangle);
  const Corners way = PerturbedPoses::kStep * CornersOf(*muscle.rate, triangle);
  TriangleRate result;
  result.turns = AreaVector(corners).norm() > 0;
  result.rate = RateBetween(PlaceOfTriangle(corners - way, result.turns),
                            PlaceOfTriangle(corners + way, result.turns)) +
                muscle.body;
  return result;
}

RowVector3d VelocityAt(const Matrix4d& rate, const RowVector3d& place) {
  return (rate * place.transpose().homogeneous()).head<3>().transpose();
}

RowVector3d Turn(const Matrix4d& rate, const RowVector3d& direction) {
  return direction * rate.topLeftCorner<3, 3>().transpose();
}

}  // namespace

void AddPlaneRates(const ContactRows& contact,
                   const Points& places,
                   const CarrierRates& owners,
                   TargetRate* rate) {
  const OneSidedRows& rows = contact.rows;
  rate->plane_speeds = Eigen::VectorXd::Zero(rows.size());
  rate->plane_turns = Points::Zero(rows.size(), 3);
  for (int k = 0; k < rows.size(); ++k) {
    const RowVector3d normal = rows.normals.row(k);
    const RowVector3d place = places.row(k);
    const double depth = rows.levels[k] - normal.dot(place);
    if (depth <= 0) continue;  // not active
    const RowVector3d foot = place + depth * normal;
    const PlaneOwner& owner = contact.owners[k];
    if (owner.IsBone()) {
      const Matrix4d& bone = owners.bones[owner.bone];
      rate->plane_speeds[k] = normal.dot(VelocityAt(bone, foot));
      rate->plane_turns.row(k) = Turn(bone, normal);
      continue;
    }
    const TriangleRate above =
        RateOfTriangle(owners.muscles[owner.muscle_above], owner.above);
    const TriangleRate below =
        RateOfTriangle(owners.muscles[owner.muscle_below], owner.below);
    rate->plane_speeds[k] =
        owner.share_above * normal.dot(VelocityAt(above.rate, foot)) +
        (1 - owner.share_above) * normal.dot(VelocityAt(below.rate, foot));
    if (!above.turns && !below.turns) continue;
    rate->plane_turns.row(k) =
        (Turn(above.rate, normal) + Turn(below.rate, normal)) /
        (above.turns + below.turns);
  }
}

}  // namespace musclewarp
