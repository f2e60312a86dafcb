// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push_rates.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

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

// Where a muscle slips over a bone, an eigenvalue of the equilibrium of its
// push passes through zero, and the derivative of the equilibrium has a pole;
// the push itself is a flow that does not slip at once (BonePush). Motions with
// eigenvalues below this one therefore fade out as these go to zero.
constexpr double kSlipping = 0.25;

// G: how each force changes as its sample moves, T blocks of 3 x 3.
std::vector<Matrix3d> ForceGradients(const BonePush& push,
                                     const std::vector<BoneTouch>& touches) {
  std::vector<Matrix3d> gradients;
  for (const BoneTouch& touch : touches) {
    gradients.push_back(ForceGradient(push, touch));
  }
  return gradients;
}

// Returns the matrix with a 3 x 3 block for each element: matrix x I.
Eigen::MatrixXd InSpace(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd blocks =
      Eigen::MatrixXd::Zero(3 * matrix.rows(), 3 * matrix.cols());
  for (Index a = 0; a < matrix.rows(); ++a) {
    for (Index b = 0; b < matrix.cols(); ++b) {
      blocks.block<3, 3>(3 * a, 3 * b).diagonal().setConstant(matrix(a, b));
    }
  }
  return blocks;
}

// Returns S^-1 right for a symmetric matrix S, with slipping motions faded out:
// the inverse 1 / s of an eigenvalue becomes s / kSlipping^2 within kSlipping,
// which is continuous.
Eigen::MatrixXd SolveWithoutSlipping(const Eigen::MatrixXd& matrix,
                                     const Eigen::MatrixXd& right) {
  Eigen::MatrixXd lowered = matrix;
  lowered.diagonal().array() -= kSlipping;
  if (lowered.llt().info() == Eigen::Success) return matrix.llt().solve(right);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  const Eigen::VectorXd inverses = eigen.eigenvalues().unaryExpr([](double s) {
    return std::abs(s) >= kSlipping ? 1 / s : s / (kSlipping * kSlipping);
  });
  return eigen.eigenvectors() *
         (inverses.asDiagonal() * (eigen.eigenvectors().transpose() * right));
}

// Returns the changes of all forces (3 T x motions) that follow from those that
// the bodies and the shape without the push ask for, as each force moves all
// samples: (I - G K)^-1 asked, where K = L L^T is the response of the samples.
// S = I - L^T G L is symmetric.
Eigen::MatrixXd ForceChanges(const BonePush& push,
                             const std::vector<BoneTouch>& touches,
                             const Eigen::MatrixXd& asked) {
  if (touches.empty()) return asked;
  std::vector<int> samples;
  for (const BoneTouch& touch : touches) samples.push_back(touch.sample);
  Eigen::MatrixXd response = push.response(samples, samples);
  // Samples that move alike make it singular.
  constexpr double kShare = 1e-12;
  response.diagonal() *= 1 + kShare;
  const Eigen::MatrixXd factor = response.llt().matrixL();
  const Eigen::MatrixXd blocks = InSpace(factor);
  const std::vector<Matrix3d> gradients = ForceGradients(push, touches);
  const auto times_gradients = [&](Eigen::MatrixXd rows) {
    for (size_t a = 0; a < gradients.size(); ++a) {
      const auto first = 3 * static_cast<Index>(a);
      rows.middleRows<3>(first) =
          (gradients[a] * rows.middleRows<3>(first)).eval();
    }
    return rows;
  };
  const Eigen::MatrixXd pulled = times_gradients(blocks);
  const Eigen::MatrixXd system =
      Eigen::MatrixXd::Identity(blocks.rows(), blocks.cols()) -
      blocks.transpose() * pulled;
  return asked +
         pulled * SolveWithoutSlipping(system, blocks.transpose() * asked);
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
  const Eigen::MatrixXd changes = ForceChanges(push, touches, asked);
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
