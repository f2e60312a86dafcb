// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push_rates.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "musclewarp/geometry/thin_product.h"
#include "musclewarp/solver/bone_touches.h"

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// How the force on a touched sample changes as it moves against the body.
Matrix3d ForceGradient(const BonePush& push, const BoneTouch& touch) {
  const BoneForce bone = ForceAt(push, touch.lack);
  return bone.force * touch.curvature -
         bone.stiffness * touch.normal.transpose() * touch.normal;
}

// I - K G: with it the changes of all forces, 3 T, give those that the bodies
// and the shape without the push ask for, as each force moves all samples.
Eigen::MatrixXd SystemOf(const BonePush& push,
                         const std::vector<BoneTouch>& touches) {
  const auto count = static_cast<Index>(touches.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(3 * count, 3 * count);
  for (Index a = 0; a < count; ++a) {
    const Matrix3d gradient = ForceGradient(push, touches[a]);
    for (Index b = 0; b < count; ++b) {
      system.block<3, 3>(3 * a, 3 * b) -=
          push.response(touches[a].sample, touches[b].sample) * gradient;
    }
  }
  return system;
}

// Returns how the forces (3 T) change as the bodies and the shape without the
// push move, and nothing gives way. `places`: of the samples.
Eigen::VectorXd AskedChanges(const BonePush& push,
                             const std::vector<BoneTouch>& touches,
                             const Points& places,
                             const PushMotion& motion) {
  constexpr double kStill = 1e-6;  // mm by rad or m: rounding
  Eigen::VectorXd changes(3 * static_cast<Index>(touches.size()));
  bool is_still = motion.free.isZero(0);
  for (size_t a = 0; a < touches.size(); ++a) {
    const BoneTouch& touch = touches[a];
    const Eigen::Matrix4d& body = motion.bones[touch.bone];
    const Eigen::RowVector3d moved =
        push.fine_from_coarse.row(touch.sample) * motion.free;
    const Vector3d carried =
        (body * places.row(touch.sample).transpose().homogeneous()).head<3>();
    is_still &= carried.norm() < kStill;
    changes.segment<3>(3 * static_cast<Index>(a)) =
        ForceGradient(push, touch) * (moved.transpose() - carried) +
        ForceAt(push, touch.lack).force * body.topLeftCorner<3, 3>() *
            touch.normal.transpose();
  }
  if (is_still) changes.setZero();
  return changes;
}

}  // namespace

std::vector<Points> PushRates(const BonePush& push,
                              const ScenePose& pose,
                              const Points& free,
                              const Points& push_now,
                              const std::vector<PushMotion>& motions) {
  const Points places = ThinProduct(push.fine_from_coarse, free + push_now);
  const std::vector<BoneTouch> touches = BoneTouches(push).At(pose, places);
  const auto count = static_cast<Index>(touches.size());
  Eigen::MatrixXd asked(3 * count, static_cast<Index>(motions.size()));
  for (size_t c = 0; c < motions.size(); ++c) {
    asked.col(static_cast<Index>(c)) =
        AskedChanges(push, touches, places, motions[c]);
  }
  const Eigen::MatrixXd changes =
      SystemOf(push, touches).partialPivLu().solve(asked);
  std::vector<int> samples;
  for (const BoneTouch& touch : touches) samples.push_back(touch.sample);
  std::vector<Points> rates;
  for (size_t c = 0; c < motions.size(); ++c) {
    const Eigen::Map<const Points> forces(
        changes.col(static_cast<Index>(c)).data(), count, 3);
    rates.push_back(ThinTransposedProduct(push.reach, samples, forces));
  }
  return rates;
}

}  // namespace musclewarp
