// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/geometry/cotangent_laplacian.h"
#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

struct MuscleModelOptions {
  OuterHullOptions hull;
  CotangentLaplacianOptions laplacian;

  // Largest distance of neighbouring skeleton samples along a line, mm. Finer
  // samples weigh the skeleton more against the shape.
  double sample_spacing = 10;

  // Weight of a skeleton row against a Laplacian row (both in mm).
  double skeleton_weight = 1;

  // Weight of all rows of one attachment together; 0 leaves them out (the
  // paper). Beyond the paper.
  double attachment_weight = 0;

  // Rows per attachment: the fine vertices in the area are thinned to this
  // many.
  int attachment_rows = 32;

  bool IsValid(std::string* error) const;
};

// Everything of one muscle that does not change with the pose. N coarse and n
// fine vertices, m samples, k attachment rows.
//
// The linear energy of paper eq. (2.8) is 1/2 |f(X)|^2 with
//
//   f(X) = [ L; S; B ] X - [ delta; s'; b' ],
//
// the right-hand side of which a pose gives (MuscleTarget). L, S and B carry
// their weights. J_f = [ L; S; B ] acts on x, y and z alike, so that
// A = J_f^T J_f is N x N.
struct MuscleModel {
  std::string name;
  std::vector<ActionLine> lines;
  std::vector<Attachment> attachments;

  Points fine_rest;          // n x 3, mm
  Triangles fine_triangles;  // closed, outward
  Points coarse_rest;        // N x 3, mm: X_0
  Triangles coarse_triangles;

  RowMajorMatrix fine_from_coarse;    // n x N mean value coordinates: W
  SparseMatrix laplacian;             // N x N: L
  Points laplacian_rest;              // N x 3: L X_0
  RowMajorMatrix skeleton;            // m x N: S
  std::vector<SegmentPoint> samples;  // m places on the lines
  std::vector<SegmentPoint> nearest_segments;  // N: s(i)
  double skeleton_weight = 1;

  RowMajorMatrix attachment;           // k x N: B
  std::vector<int> attachment_of;      // k: index into attachments
  Points attachment_rest;              // k x 3: B X_0 / weight of the row
  Eigen::VectorXd attachment_weights;  // k

  double rest_volume = 0;                     // of the fine mesh, mm^3: V_hat
  double coarse_rest_volume = 0;              // of the coarse mesh, mm^3
  double rest_area = 0;                       // of the fine mesh, mm^2
  Eigen::LLT<Eigen::MatrixXd> normal_matrix;  // A = U^T U, factored once
};

// `hull` is the closed coarse mesh around `fine`. Preconditions (CHECKed): the
// options are valid, both meshes closed 2-manifolds, there is a line. Throws
// InputError naming the muscle if its lines do not determine the shape (A is
// singular).
MuscleModel PrepareMuscle(const SceneMuscle& muscle,
                          const TriangleSoup& fine,
                          const TriangleSoup& hull,
                          const MuscleModelOptions& options);

}  // namespace musclewarp
