// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_target.h"

#include "musclewarp/geometry/thin_product.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/sampling.h"
#include "musclewarp/skeleton/segment_rotation.h"

namespace musclewarp {
namespace {

// Returns the stretch of the muscle at the points of its bending rows. Fixed
// guides do not spread theirs over the muscle, so that it counts as 1.
Eigen::VectorXd StretchesAt(const MuscleModel& model,
                            const std::vector<LineTarget>& guides) {
  if (model.guides.rule == LineRule::kFixed) {
    return Eigen::VectorXd::Ones(model.bending.rest.rows());
  }
  return StretchesOf(model.bending.field, model.guides.lines, guides);
}

}  // namespace

MuscleTarget TargetOf(const MuscleModel& model,
                      const ScenePose& pose,
                      const PreRotationOptions& options) {
  const std::vector<LineTarget> guides =
      GuideTargets(model.guides, LineTargets(model.lines, pose));
  MuscleTarget target;

  target.laplacian = model.laplacian_rest;
  const std::vector<Eigen::Matrix3d> rotations = RotationsOf(
      model.rotations, model.guides.lines, guides, options.use_body_twist);
  for (size_t i = 0; i < rotations.size(); ++i) {
    target.laplacian.row(i) =
        model.laplacian_rest.row(i) * rotations[i].transpose();
  }

  target.skeleton.resize(model.samples.size(), 3);
  for (size_t i = 0; i < model.samples.size(); ++i) {
    target.skeleton.row(i) =
        model.skeleton_weights[i] *
        PointOnSegment(guides[model.samples[i].line].points, model.samples[i]);
  }

  target.attachment.resize(model.attachment_of.size(), 3);
  std::vector<Eigen::Matrix4d> transforms;
  for (size_t a = 0; a < model.attachments.size(); ++a) {
    transforms.push_back(AttachmentTransform(model, static_cast<int>(a), pose));
  }
  for (size_t i = 0; i < model.attachment_of.size(); ++i) {
    target.attachment.row(i) = model.attachment_weights[i] *
                               Transformed(model.attachment_rest.row(i),
                                           transforms[model.attachment_of[i]]);
  }

  target.bending.resize(0, 3);
  if (!model.bending.points.empty()) {
    target.bending = BendingTargets(model.bending,
                                    RotationsOf(model.bending.field,
                                                model.guides.lines,
                                                guides,
                                                options.use_body_twist),
                                    StretchesAt(model, guides));
  }
  const auto push = pose.pushes.find(model.name);
  if (push != pose.pushes.end()) AddRowsOf(model, push->second, &target);
  return target;
}

void AddRowsOf(const MuscleModel& model,
               const Points& displacements,
               MuscleTarget* target) {
  target->laplacian += model.laplacian * displacements;
  target->skeleton += ThinProduct(model.skeleton, displacements);
  target->attachment += ThinProduct(model.attachment, displacements);
  target->bending += ThinProduct(model.bending.from_coarse, displacements);
}

Points LinearDescent(const MuscleModel& model,
                     const MuscleTarget& target,
                     const Points& coarse) {
  Points descent = model.laplacian.transpose() *
                   (target.laplacian - model.laplacian * coarse);
  const auto add = [&](const RowMajorMatrix& rows, const Points& targets) {
    descent += ThinTransposedProduct(rows, targets - ThinProduct(rows, coarse));
  };
  add(model.skeleton, target.skeleton);
  add(model.attachment, target.attachment);
  add(model.bending.from_coarse, target.bending);
  return descent;
}

double LinearEnergy(const MuscleModel& model,
                    const MuscleTarget& target,
                    const Points& coarse) {
  const auto square = [&](const RowMajorMatrix& rows, const Points& targets) {
    return (ThinProduct(rows, coarse) - targets).squaredNorm();
  };
  return 0.5 * ((model.laplacian * coarse - target.laplacian).squaredNorm() +
                square(model.skeleton, target.skeleton) +
                square(model.attachment, target.attachment) +
                square(model.bending.from_coarse, target.bending));
}

Points UnconstrainedMinimizer(const MuscleModel& model,
                              const MuscleTarget& target) {
  return model.coarse_rest + model.normal_matrix.solve(LinearDescent(
                                 model, target, model.coarse_rest));
}

}  // namespace musclewarp
