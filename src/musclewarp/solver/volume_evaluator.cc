// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_evaluator.h"

#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {

VolumeEvaluator::VolumeEvaluator(const MuscleModel& model,
                                 const VertexCorrections* corrections)
    : model_(model), corrections_(corrections) {}

void VolumeEvaluator::SetMesh(VolumeMesh mesh) {
  if (mesh == mesh_) return;
  mesh_ = mesh;
  Forget();
}

double VolumeEvaluator::Error(const Points& coarse) {
  if (coarse_.rows() == coarse.rows() && coarse_ == coarse) return error_;
  coarse_ = coarse;
  moved_ = coarse;
  if (corrections_) corrections_->held_coarse.PutBack(&moved_);
  if (mesh_ == VolumeMesh::kCoarse) {
    error_ = (SignedVolume(moved_, model_.coarse_triangles) -
              model_.coarse_rest_volume) *
             model_.rest_volume / model_.coarse_rest_volume;
    return error_;
  }
  moved_ = Product(model_.fine_from_coarse, moved_);
  if (corrections_) {
    if (corrections_->fine_offset.rows() > 0)
      moved_ += corrections_->fine_offset;
    corrections_->held_fine.PutBack(&moved_);
  }
  error_ = SignedVolume(moved_, model_.fine_triangles) - model_.rest_volume;
  return error_;
}

const Points& VolumeEvaluator::Gradient(const Points& coarse) {
  if (gradient_.rows() == coarse.rows() &&
      (coarse - gradient_place_).rowwise().norm().maxCoeff() <= reuse_within_) {
    return gradient_;
  }
  Error(coarse);
  gradient_place_ = coarse;
  if (mesh_ == VolumeMesh::kCoarse) {
    gradient_ = model_.rest_volume / model_.coarse_rest_volume *
                VolumeGradient(moved_, model_.coarse_triangles);
  } else {
    Points fine_gradient = VolumeGradient(moved_, model_.fine_triangles);
    if (corrections_) corrections_->held_fine.ClearRows(&fine_gradient);
    gradient_ = TransposedProduct(model_.fine_from_coarse, fine_gradient);
  }
  if (corrections_) corrections_->held_coarse.ClearRows(&gradient_);
  return gradient_;
}

}  // namespace musclewarp
