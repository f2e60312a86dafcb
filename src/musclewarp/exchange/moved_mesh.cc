// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/moved_mesh.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <vector>

namespace musclewarp {
namespace {

using StiffnessMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Returns the gradients (rows) of the four linear functions that are one at a
// corner of the element and zero at the others, times 6 volumes.
Eigen::Matrix<double, 4, 3> ScaledGradients(const TetrahedralMesh& mesh,
                                            Eigen::Index t) {
  Eigen::Matrix<double, 4, 3> gradients;
  for (int f = 0; f < 4; ++f) {
    // The gradient of the corner opposite a face points inward.
    const int* const k = kFaceCorners[f];
    const Eigen::RowVector3d a = mesh.points.row(mesh.tetrahedra(t, k[0]));
    const Eigen::RowVector3d b = mesh.points.row(mesh.tetrahedra(t, k[1]));
    const Eigen::RowVector3d c = mesh.points.row(mesh.tetrahedra(t, k[2]));
    gradients.row(6 - k[0] - k[1] - k[2]) = -(b - a).cross(c - a);
  }
  return gradients;
}

}  // namespace

struct HarmonicMover::Factors {
  Eigen::Index surface_points;
  StiffnessMatrix from_surface;  // inside x surface
  Eigen::SimplicialLDLT<StiffnessMatrix> inside;
};

HarmonicMover::HarmonicMover(TetrahedralMesh mesh, Eigen::Index surface_points)
    : mesh_(std::move(mesh)), factors_(std::make_unique<Factors>()) {
  factors_->surface_points = surface_points;
  const Eigen::Index inside = mesh_.points.rows() - surface_points;
  const Eigen::VectorXd volumes = Volumes(mesh_);
  Triplets within, across;
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    CHECK_GT(volumes[t], 0);
    const Eigen::Matrix<double, 4, 3> gradients = ScaledGradients(mesh_, t);
    const Eigen::Matrix4d stiffness =
        gradients * gradients.transpose() / (36 * volumes[t]);
    for (int i = 0; i < 4; ++i) {
      const Eigen::Index row = mesh_.tetrahedra(t, i) - surface_points;
      if (row < 0) continue;
      for (int k = 0; k < 4; ++k) {
        const Eigen::Index column = mesh_.tetrahedra(t, k) - surface_points;
        if (column >= 0) {
          within.emplace_back(row, column, stiffness(i, k));
        } else {
          across.emplace_back(row, column + surface_points, -stiffness(i, k));
        }
      }
    }
  }
  StiffnessMatrix matrix(inside, inside);
  matrix.setFromTriplets(within.begin(), within.end());
  factors_->from_surface.resize(inside, surface_points);
  factors_->from_surface.setFromTriplets(across.begin(), across.end());
  if (inside == 0) return;
  factors_->inside.compute(matrix);
  CHECK_EQ(factors_->inside.info(), Eigen::Success)
      << "a point without an element";
}

HarmonicMover::~HarmonicMover() = default;

TetrahedralMesh HarmonicMover::MoveTo(const Points& surface) const {
  const Eigen::Index count = factors_->surface_points;
  CHECK_EQ(surface.rows(), count);
  TetrahedralMesh moved = mesh_;
  moved.points.topRows(count) = surface;
  if (count == mesh_.points.rows()) return moved;
  const Eigen::MatrixXd displacement = surface - mesh_.points.topRows(count);
  const Eigen::MatrixXd force = factors_->from_surface * displacement;
  const Eigen::MatrixXd inside = factors_->inside.solve(force);
  moved.points.bottomRows(inside.rows()) += inside;
  return moved;
}

}  // namespace musclewarp
