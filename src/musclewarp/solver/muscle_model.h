// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/geometry/cotangent_laplacian.h"
#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/guides.h"
#include "musclewarp/skeleton/rotation_field.h"
#include "musclewarp/solver/bending_rows.h"
#include "musclewarp/solver/soft_carrier.h"

namespace musclewarp {

struct BonePush;  // bone_push.h

struct MuscleModelOptions {
  // How the coarse hull is made, and how its Laplacian is weighted and bounded.
  // With LaplacianWeights::kArea all other rows are weighted likewise, so that
  // neither the size of the hull nor the spacing of samples changes the shape:
  // skeleton rows by length, attachment rows by area, and pre-rotations are
  // smooth. With kPaper each row counts as much as any other, and pre-rotations
  // are those of the nearest segments.
  OuterHullOptions hull;
  CotangentLaplacianOptions laplacian;

  // How the muscle follows its lines where they get longer or shorter.
  LineRule line_rule = LineRule::kTendon;

  // Largest distance between neighbouring skeleton samples along a line, mm.
  // With kPaper a smaller distance gives more rows, which weigh the skeleton
  // more against the shape.
  double sample_spacing = 10;

  // Weight of a skeleton row against a Laplacian row (both are in mm). With
  // kArea it is that of 10 mm of a line.
  double skeleton_weight = 1;

  // Weight of all rows of one attachment together. Attachment rows go beyond
  // the paper; 0 leaves them out. With weight 1, coarse meshes deviate from
  // attachments by up to 11 mm (thigh, flexion by 45 degrees), which the
  // offsets of fine vertices have to make up; with 8 by at most 4 mm, unless a
  // tendon blocks the attachment.
  double attachment_weight = 8;

  // Largest number of rows per attachment. If more fine vertices lie in the
  // area, they are thinned to this many.
  int attachment_rows = 32;

  // How stiff fibres are against bending, w in bending_rows.h: 1 is as stiff as
  // the surface. Bending rows go beyond the paper; 0 leaves them out.
  double bending_weight = 2;

  // Returns false and names the field, its value and the rule if a field, one
  // of `hull` and `laplacian` included, is out of range.
  bool IsValid(std::string* error) const;
};

// Everything of one muscle that does not change with the pose, prepared once:
// the meshes, the matrices of its energy and the factorised normal matrix. The
// sizes are N coarse and n fine vertices, m skeleton samples, k attachment rows
// and r bending rows.
//
// The linear energy of paper eq. (2.8) is 1/2 |f(X)|^2 with
//
//   f(X) = [ L; S; B; D ] X - [ delta; s'; b'; d' ].
//
// L, S, B and D are here and include their weights; the right-hand side depends
// on the pose (MuscleTarget). J_f = [ L; S; B; D ] acts on x, y and z alike, so
// that A = J_f^T J_f is N x N rather than 3N x 3N.
struct MuscleModel {
  std::string name;
  std::vector<ActionLine> lines;
  Guides guides;  // made of the lines
  std::vector<Attachment> attachments;
  std::map<int, SoftCarrier>
      carriers;  // of attachments to soft parts, by index

  // The fine mesh: closed and oriented outward.
  Points fine_rest;  // n x 3, mm
  Triangles fine_triangles;
  // The coarse hull around it; its vertices are the unknowns.
  Points coarse_rest;  // N x 3, mm: X_0
  Triangles coarse_triangles;

  // W: the mean value coordinates of the fine vertices, so that W X are the
  // fine vertices of a coarse mesh X. n x N.
  FineMap fine_from_coarse;

  // How rows weigh (MuscleModelOptions::laplacian).
  LaplacianWeights weights = LaplacianWeights::kArea;

  // Laplacian rows, paper eq. (2.1) to (2.3).
  SparseMatrix laplacian;   // N x N: L
  Points laplacian_rest;    // N x 3, mm: L X_0
  RotationField rotations;  // of N points; none without lines

  // Skeleton rows, paper eq. (2.4) and (2.5).
  RowMajorMatrix skeleton;            // m x N: S
  std::vector<SegmentPoint> samples;  // m places on the guides
  Eigen::VectorXd skeleton_weights;   // m

  // Attachment rows.
  RowMajorMatrix attachment;           // k x N: B
  std::vector<int> attachment_of;      // k: index into attachments
  Points attachment_rest;              // k x 3, mm: B X_0 / weight of the row
  Eigen::VectorXd attachment_weights;  // k

  BendingRows bending;  // r rows

  double rest_volume = 0;         // of the fine mesh, mm^3: V_hat
  double coarse_rest_volume = 0;  // of the coarse mesh, mm^3
  double rest_area = 0;           // of the fine mesh, mm^2

  // The Cholesky factorisation A = U^T U. Empty without lines.
  Eigen::LLT<Eigen::MatrixXd> normal_matrix;

  // How bones push it aside; null if none can.
  std::shared_ptr<const BonePush> bone_push;

  // False of a muscle without lines: its place is not determined, so that it
  // cannot be solved for, and stays as it is.
  bool HasLines() const { return !lines.empty(); }
};

// What is known of the inside of a muscle at rest, in mm. Either may be empty.
struct MuscleInterior {
  InsidePoints points;         // GuidesOf
  std::vector<Points> fibres;  // those that resist bending (bending_rows.h)
};

// Prepares a muscle: `fine` is its mesh in the rest pose and `hull` the closed
// coarse mesh around it, both in mm. Factorising A costs O(N^3).
// Preconditions (CHECKed where cheap): the options are valid, both meshes are
// closed 2-manifolds oriented outward.
// Throws InputError naming the muscle if its lines do not determine the shape,
// that is, if A is singular.
MuscleModel PrepareMuscle(const SceneMuscle& muscle,
                          const TriangleSoup& fine,
                          const TriangleSoup& hull,
                          const MuscleInterior& interior,
                          const MuscleModelOptions& options);

// Returns target_from_rest of an attachment in a pose, mm: that of its body, or
// of what carries it.
Eigen::Matrix4d AttachmentTransform(const MuscleModel& model,
                                    int attachment,
                                    const ScenePose& pose);

// Factorises the normal matrix of a muscle of which everything else is there,
// as PrepareMuscle() does in the end, if the muscle has lines. Throws
// InputError if it is singular.
void FactorNormalMatrix(MuscleModel* model);

}  // namespace musclewarp
