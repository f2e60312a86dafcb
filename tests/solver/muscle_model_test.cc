// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/skeleton/sampling.h"
#include "support/input_errors.h"
#include "support/invalid_options.h"
#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// Of sums of mean value coordinates times coordinates of size 100, mm.
constexpr double kCarriedRounding = 1e-11;

MuscleModelOptions WithFiveAttachmentRows() {
  MuscleModelOptions options;
  options.skeleton_weight = 1.5;
  options.attachment_weight = 2;
  options.attachment_rows = 5;
  return options;
}

}  // namespace

TEST(MuscleModel, MeasuresBothMeshesAtRest) {
  const TriangleSoup fine = Spindle(12, 60, 3);
  const TriangleSoup hull = Spindle(15, 66, 2);
  const MuscleModel model = SpindleModel();
  EXPECT_EQ(model.rest_volume, SignedVolume(fine.points, fine.triangles));
  EXPECT_EQ(model.coarse_rest_volume,
            SignedVolume(hull.points, hull.triangles));
  EXPECT_EQ(model.rest_area, SurfaceArea(fine.points, fine.triangles));
}

TEST(MuscleModel, FineVerticesFollowTheHull) {
  const MuscleModel model = SpindleModel();
  ASSERT_EQ(model.fine_from_coarse.rows(), model.fine_rest.rows());
  EXPECT_LT(
      (Product(model.fine_from_coarse, model.coarse_rest) - model.fine_rest)
          .cwiseAbs()
          .maxCoeff(),
      kCarriedRounding);
}

TEST(MuscleModel, SkeletonRowsGiveTheWeightedSamples) {
  const MuscleModel model = SpindleModel(WithFiveAttachmentRows());
  const Points samples = model.skeleton * model.coarse_rest;
  ASSERT_EQ(samples.rows(), static_cast<Eigen::Index>(model.samples.size()));
  for (size_t i = 0; i < model.samples.size(); ++i) {
    const Eigen::RowVector3d place = PointOnSegment(
        model.guides.lines[model.samples[i].line].rest, model.samples[i]);
    EXPECT_LT((samples.row(i) - model.skeleton_weights[i] * place).norm(),
              kCarriedRounding);
  }
  MuscleModelOptions finer;
  finer.sample_spacing = 5;
  EXPECT_GT(SpindleModel(finer).samples.size(), model.samples.size());
}

// The rows of a line together weigh as much however many there are.
TEST(MuscleModel, ByAreaSkeletonRowsWeighByLength) {
  MuscleModelOptions options = NoAttachmentRows();
  options.laplacian.weights = LaplacianWeights::kArea;
  const auto sum = [&](double spacing) {
    options.sample_spacing = spacing;
    return SpindleModel(options).skeleton_weights.squaredNorm();
  };
  double length = 0;
  for (const ActionLine& line : SpindleMuscle().lines) {
    length += PolylineLength(line.rest);
  }
  for (const double spacing : {2.5, 10.0, 40.0}) {
    EXPECT_NEAR(sum(spacing), length / 10, 1e-12 * length);
  }
}

TEST(MuscleModel, AttachmentRowsShareTheirWeightAndAreLeftOutWithoutOne) {
  EXPECT_EQ(SpindleModel().attachment.rows(), 0);
  const MuscleModel model = SpindleModel(WithFiveAttachmentRows());
  ASSERT_EQ(model.attachment.rows(), 2 * 5);
  const Points places = model.attachment * model.coarse_rest;
  double squared_weight[2] = {0, 0};
  for (int i = 0; i < 10; ++i) {
    const double weight = model.attachment_weights[i];
    squared_weight[model.attachment_of[i]] += weight * weight;
    EXPECT_LT((places.row(i) - weight * model.attachment_rest.row(i)).norm(),
              kCarriedRounding);
    // Within the radius of 12 mm about the end of the spindle.
    const Attachment& attachment = model.attachments[model.attachment_of[i]];
    EXPECT_LE((model.attachment_rest.row(i) - attachment.points.row(0)).norm(),
              attachment.radius);
  }
  for (const double sum : squared_weight) EXPECT_NEAR(sum, 2 * 2, 1e-12);
}

TEST(MuscleModel, TheNormalMatrixIsThatOfAllRows) {
  const MuscleModel model = SpindleModel(WithFiveAttachmentRows());
  Eigen::MatrixXd laplacian(model.laplacian);
  const Eigen::MatrixXd expected =
      laplacian.transpose() * laplacian +
      model.skeleton.transpose() * model.skeleton +
      model.attachment.transpose() * model.attachment +
      model.bending.from_coarse.transpose() * model.bending.from_coarse;
  EXPECT_LT((model.normal_matrix.reconstructedMatrix() - expected).norm(),
            1e-13 * expected.norm());
}

TEST(MuscleModel, OnThePapersRowsEveryCoarseVertexHasANearestSegment) {
  MuscleModelOptions options = NoAttachmentRows();
  options.laplacian.weights = LaplacianWeights::kPaper;
  const MuscleModel model = SpindleModel(options);
  const std::vector<SegmentPoint>& nearest = model.rotations.places;
  ASSERT_EQ(nearest.size(), static_cast<size_t>(model.coarse_rest.rows()));
  // The vertex farthest along +x is nearer to the line along the side.
  Eigen::Index side;
  model.coarse_rest.col(0).maxCoeff(&side);
  EXPECT_EQ(model.lines[nearest[side].line].name, "side");
  Eigen::Index other;
  model.coarse_rest.col(0).minCoeff(&other);
  EXPECT_EQ(model.lines[nearest[other].line].name, "middle");
}

// A vertex of the hull that belongs to no triangle has no entry in the
// Laplacian rows, and the weight of the skeleton rows underflows when it is
// squared: the row of A is exactly zero.
TEST(MuscleModel, RefusesLinesThatDoNotDetermineTheShape) {
  TriangleSoup hull = Spindle(15, 66, 1);
  hull.points.conservativeResize(hull.points.rows() + 1, 3);
  hull.points.bottomRows(1) << 100, 0, 0;
  MuscleModelOptions options = NoAttachmentRows();
  options.skeleton_weight = 1e-200;
  ExpectInputError(
      [&] {
        PrepareMuscle(SpindleMuscle(), Spindle(12, 60, 1), hull, {}, options);
      },
      {"muscle spindle", "lines do not determine its shape", "give lines"});
}

TEST(MuscleModelOptions, DefaultsAreValid) {
  ExpectValid(MuscleModelOptions());
}

TEST(MuscleModelOptions, RefuseValuesOutOfRange) {
  ExpectRefused<MuscleModelOptions>(
      [](auto* options) { options->sample_spacing = 0; },
      "MuscleModelOptions::sample_spacing is 0, allowed: 0.01 mm or above");
  ExpectRefused<MuscleModelOptions>(
      [](auto* options) { options->skeleton_weight = -0.5; },
      "MuscleModelOptions::skeleton_weight is -0.5, allowed: above 0, at most "
      "1e6");
  ExpectRefused<MuscleModelOptions>(
      [](auto* options) { options->attachment_weight = -1; },
      "MuscleModelOptions::attachment_weight is -1, allowed: 0 to 1e6");
  ExpectRefused<MuscleModelOptions>(
      [](auto* options) { options->attachment_rows = 0; },
      "MuscleModelOptions::attachment_rows is 0, allowed: above 0");
}

TEST(MuscleModelOptions, RefuseWhatTheirPartsRefuse) {
  std::string error;
  MuscleModelOptions options;
  options.hull.coarse_vertices = 1;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("OuterHullOptions::coarse_vertices is 1"),
            std::string::npos);
  options = MuscleModelOptions();
  options.laplacian.min_weight = -1;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("CotangentLaplacianOptions::min_weight is -1"),
            std::string::npos);
}

}  // namespace musclewarp
