// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_model.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/invalid_option.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/covered_part.h"
#include "musclewarp/skeleton/sampling.h"
#include "musclewarp/solver/attachment_rows.h"

namespace musclewarp {
namespace {

// The length of line for which a skeleton row has its full weight, mm.
constexpr double kLengthOfRow = 10;

void AddSkeletonRows(const MuscleModelOptions& options, MuscleModel* model) {
  const std::vector<ActionLine>& guides = model->guides.lines;
  model->samples = SamplesAlong(
      SampleLines(guides, options.sample_spacing), guides, model->fine_rest);
  Points rest(model->samples.size(), 3);
  for (size_t i = 0; i < model->samples.size(); ++i) {
    rest.row(i) =
        PointOnSegment(guides[model->samples[i].line].rest, model->samples[i]);
  }
  model->skeleton_weights =
      Eigen::VectorXd::Constant(model->samples.size(), options.skeleton_weight);
  if (options.laplacian.weights == LaplacianWeights::kArea) {
    model->skeleton_weights.array() *=
        (SampleLengths(guides, model->samples) / kLengthOfRow).array().sqrt();
  }
  model->skeleton =
      model->skeleton_weights.asDiagonal() *
      MeanValueCoordinates(rest, model->coarse_rest, model->coarse_triangles);
}

// Returns how points (#V x 3) of the muscle at rest turn with its lines.
RotationField FieldAt(const Points& points, const MuscleModel& model) {
  const std::vector<ActionLine>& guides = model.guides.lines;
  if (model.weights == LaplacianWeights::kPaper) {
    return NearestRotations(points, guides);
  }
  // Of a cylinder this is its radius. Lines are cut into pieces of half of it,
  // which a thin sheet would make countless.
  constexpr double kLeastRadius = 2;  // mm
  const double mean_radius = 2 * model.rest_volume / model.rest_area;
  return SmoothRotations(points, guides, std::max(mean_radius, kLeastRadius));
}

void AddBendingRows(const MuscleModelOptions& options,
                    const std::vector<Points>& fibres,
                    MuscleModel* model) {
  const double length = LengthScale(
      model->coarse_rest, model->coarse_triangles, options.laplacian);
  const double area = SurfaceArea(model->coarse_rest, model->coarse_triangles);
  const bool has_rows = options.bending_weight > 0 && model->HasLines();
  model->bending =
      MakeBendingRows(has_rows ? fibres : std::vector<Points>(),
                      model->coarse_rest,
                      model->coarse_triangles,
                      options.bending_weight * length * std::sqrt(area));
  if (model->bending.points.empty()) return;
  model->bending.field = FieldAt(model->bending.rest, *model);
}

AttachmentRows RowsOf(const MuscleModelOptions& options,
                      const Attachment& attachment,
                      const MuscleModel& model) {
  const int max_rows = options.attachment_rows;
  if (options.laplacian.weights == LaplacianWeights::kPaper) {
    return EqualRows(attachment, model.fine_rest, max_rows);
  }
  return RowsByArea(attachment,
                    model.fine_rest,
                    VertexAreas(model.fine_rest, model.fine_triangles),
                    max_rows);
}

void AddAttachmentRows(const MuscleModelOptions& options, MuscleModel* model) {
  std::vector<int> vertices;
  std::vector<double> weights;
  if (options.attachment_weight > 0) {
    for (size_t a = 0; a < model->attachments.size(); ++a) {
      const AttachmentRows rows =
          RowsOf(options, model->attachments[a], *model);
      for (size_t i = 0; i < rows.vertices.size(); ++i) {
        vertices.push_back(rows.vertices[i]);
        weights.push_back(options.attachment_weight * rows.weights[i]);
        model->attachment_of.push_back(a);
      }
    }
  }
  const RowMajorMatrix coordinates = RowsOf(model->fine_from_coarse, vertices);
  const Eigen::Index rows = vertices.size();
  model->attachment.resize(rows, model->coarse_rest.rows());
  model->attachment_rest.resize(rows, 3);
  model->attachment_weights.resize(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    model->attachment.row(i) = weights[i] * coordinates.row(i);
    model->attachment_rest.row(i) = model->fine_rest.row(vertices[i]);
    model->attachment_weights[i] = weights[i];
  }
}

// Samples closer together say nothing new, and take forever.
constexpr double kLeastSpacing = 0.01;  // mm

// The square of a weight stands beside Laplacian rows of size 1 in the normal
// matrix: above this they keep no more than four digits.
constexpr double kLargestWeight = 1e6;

}  // namespace

bool MuscleModelOptions::IsValid(std::string* error) const {
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption("MuscleModelOptions::" + field, value, allowed, error);
  };
  if (!hull.IsValid(error) || !laplacian.IsValid(error)) return false;
  if (!(sample_spacing >= kLeastSpacing)) {
    return fail("sample_spacing", sample_spacing, "0.01 mm or above");
  }
  if (!(skeleton_weight > 0 && skeleton_weight <= kLargestWeight)) {
    return fail("skeleton_weight", skeleton_weight, "above 0, at most 1e6");
  }
  if (!(attachment_weight >= 0 && attachment_weight <= kLargestWeight)) {
    return fail("attachment_weight", attachment_weight, "0 to 1e6");
  }
  if (!(bending_weight >= 0 && bending_weight <= kLargestWeight)) {
    return fail("bending_weight", bending_weight, "0 to 1e6");
  }
  if (attachment_rows < 1) {
    return fail("attachment_rows", attachment_rows, "above 0");
  }
  return true;
}

Eigen::Matrix4d AttachmentTransform(const MuscleModel& model,
                                    int attachment,
                                    const ScenePose& pose) {
  const auto carrier = model.carriers.find(attachment);
  if (carrier != model.carriers.end()) {
    return TransformOf(carrier->second, pose);
  }
  return BodyTransform(pose, model.attachments[attachment].body);
}

void FactorNormalMatrix(MuscleModel* model) {
  if (!model->HasLines()) return;
  Eigen::MatrixXd normal(SparseMatrix(model->laplacian.transpose()) *
                         model->laplacian);
  normal += model->skeleton.transpose() * model->skeleton;
  normal += model->attachment.transpose() * model->attachment;
  const RowMajorMatrix& bending = model->bending.from_coarse;
  normal += bending.transpose() * bending;
  model->normal_matrix.compute(normal);
  if (model->normal_matrix.info() != Eigen::Success) {
    throw InputError("muscle " + model->name,
                     "its lines do not determine its shape (the normal matrix "
                     "is singular)",
                     "give lines of some length near the muscle");
  }
}

MuscleModel PrepareMuscle(const SceneMuscle& muscle,
                          const TriangleSoup& fine,
                          const TriangleSoup& hull,
                          const MuscleInterior& interior,
                          const MuscleModelOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  MuscleModel model;
  model.name = muscle.name;
  model.lines = muscle.lines;
  model.guides = GuidesOf(muscle.lines, options.line_rule, interior.points);
  model.attachments = muscle.attachments;
  model.fine_rest = fine.points;
  model.fine_triangles = fine.triangles;
  model.coarse_rest = hull.points;
  model.coarse_triangles = hull.triangles;
  model.rest_volume = SignedVolume(fine.points, fine.triangles);
  model.coarse_rest_volume = SignedVolume(hull.points, hull.triangles);
  model.rest_area = SurfaceArea(fine.points, fine.triangles);

  model.fine_from_coarse = MakeFineMap(
      MeanValueCoordinates(fine.points, hull.points, hull.triangles),
      hull.points);
  model.weights = options.laplacian.weights;
  model.laplacian =
      CotangentLaplacian(hull.points, hull.triangles, options.laplacian);
  model.laplacian_rest = model.laplacian * hull.points;
  if (model.HasLines()) model.rotations = FieldAt(hull.points, model);
  AddSkeletonRows(options, &model);
  AddAttachmentRows(options, &model);
  AddBendingRows(options, interior.fibres, &model);
  FactorNormalMatrix(&model);
  return model;
}

}  // namespace musclewarp
