// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/shape_derivative.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <vector>

#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/solver/one_sided_rows.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// What moment arms are promised to hold, mm by rad. A hundredth of it is
// demanded of derivatives of vertices, in soft directions of the shape too.
constexpr double kArm = 1e-3;
constexpr double kVertex = 1e-2;

// The step of central differences of whole solves, rad. The third derivative of
// places 60 mm from the axis adds some 1e-5 mm by rad, solves that end within
// 1e-9 mm add 1e-6.
constexpr double kSolveStep = 1e-3;

// The target in the pose `q`, with one-sided rows.
using TargetAt = std::function<MuscleTarget(double q)>;

// The rate of a target by central differences with a small step, as that of a
// model is found, with the rates of the planes from their places on both sides.
TargetRate RateAt(const TargetAt& target_at,
                  const MuscleModel& model,
                  const Points& coarse,
                  double q) {
  constexpr double kSmall = 1e-4;
  const MuscleTarget before = target_at(q - kSmall), here = target_at(q),
                     after = target_at(q + kSmall);
  const double way = 2 * kSmall;
  TargetRate rate;
  rate.linear.laplacian = (after.laplacian - before.laplacian) / way;
  rate.linear.skeleton = (after.skeleton - before.skeleton) / way;
  rate.linear.attachment = (after.attachment - before.attachment) / way;
  rate.linear.bending = (after.bending - before.bending) / way;
  const OneSidedRows& rows = here.one_sided;
  const Points places = FineFromCoarse(model, rows) * coarse;
  rate.plane_turns =
      rows.size() == 0
          ? Points(0, 3)
          : Points((after.one_sided.normals - before.one_sided.normals) / way);
  rate.plane_speeds.resize(rows.size());
  for (int k = 0; k < rows.size(); ++k) {
    const Eigen::RowVector3d normal = rows.normals.row(k);
    const Eigen::RowVector3d foot =
        places.row(k) + (rows.levels[k] - normal.dot(places.row(k))) * normal;
    // level = n . c for every point c of the plane.
    rate.plane_speeds[k] =
        (after.one_sided.levels[k] - before.one_sided.levels[k]) / way -
        rate.plane_turns.row(k).dot(foot);
  }
  return rate;
}

// Expects that the derivative of a shape is that of whole solves.
void ExpectDerivativeOfSolves(const MuscleModel& model,
                              const TargetAt& target_at,
                              double q) {
  const MuscleTarget target = target_at(q);
  const Points coarse = SolvedTightly(model, target);
  const std::vector<ShapeRate> rates =
      DifferentiateShape(model,
                         target,
                         coarse,
                         Product(model.fine_from_coarse, coarse),
                         {RateAt(target_at, model, coarse, q)});
  ASSERT_EQ(rates.size(), 1u);
  EXPECT_TRUE(rates[0].is_converged);
  EXPECT_LT(rates[0].iterations, 30);
  const Points difference = (SolvedTightly(model, target_at(q + kSolveStep)) -
                             SolvedTightly(model, target_at(q - kSolveStep))) /
                            (2 * kSolveStep);
  // The shape moves by more than it is asked for by far.
  EXPECT_GT(difference.rowwise().norm().maxCoeff(), 10);
  EXPECT_LT((rates[0].coarse - difference).rowwise().norm().maxCoeff(),
            kVertex);
  // The derivative of the distance of two fine vertices: a moment arm.
  const Points fine = Product(model.fine_from_coarse, coarse);
  const Points exact = Product(model.fine_from_coarse, rates[0].coarse);
  EXPECT_LT((rates[0].fine - exact).rowwise().norm().maxCoeff(), kVertex / 100);
  const Points of_solves = Product(model.fine_from_coarse, difference);
  Eigen::Index top, bottom;
  model.fine_rest.col(2).maxCoeff(&top);
  model.fine_rest.col(2).minCoeff(&bottom);
  const Eigen::RowVector3d along =
      (fine.row(top) - fine.row(bottom)).normalized();
  EXPECT_NEAR(along.dot(exact.row(top) - exact.row(bottom)),
              along.dot(of_solves.row(top) - of_solves.row(bottom)),
              kArm);
}

TEST(DifferentiateShape, IsTheDerivativeOfTheSolve) {
  struct Case {
    LaplacianWeights weights;
    double attachment_weight;
  };
  for (const Case& c : {Case{LaplacianWeights::kPaper, 0},
                        Case{LaplacianWeights::kPaper, 8},
                        Case{LaplacianWeights::kArea, 8}}) {
    MuscleModelOptions options;
    options.laplacian.weights = c.weights;
    options.attachment_weight = c.attachment_weight;
    const MuscleModel model = SpindleModel(options);
    for (const double angle : {-0.6, 0.1, 0.8}) {
      ExpectDerivativeOfSolves(
          model,
          [&](double q) { return TargetOf(model, BentPose(q), {}); },
          angle);
    }
  }
}

// Planes of a bone that turns with the femur and squeezes the muscle from two
// sides. Two in three of them are active, and stay so.
TEST(DifferentiateShape, HoldsActiveRowsOnPlanesThatMove) {
  const MuscleModel model = SpindleModel();
  const double angle = 0.5;
  const Points free =
      Product(model.fine_from_coarse,
              SolvedTightly(model, TargetOf(model, BentPose(angle), {})));
  std::vector<VertexHalfSpace> at_angle;
  for (int v = 0; v < free.rows(); v += 5) {
    // 2 mm in the way, or 4 mm clear.
    const double depth = at_angle.size() % 3 == 0 ? -4 : 2;
    const double side = model.fine_rest(v, 0) > 0 ? -1 : 1;
    const Eigen::RowVector3d normal =
        Eigen::RowVector3d(side, 0.2, 0.3).normalized();
    at_angle.push_back({v, {normal, normal.dot(free.row(v)) + depth}});
  }
  const TargetAt target_at = [&](double q) {
    MuscleTarget target = TargetOf(model, BentPose(q), {});
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(q - angle, Eigen::Vector3d::UnitY())
            .toRotationMatrix();
    std::vector<VertexHalfSpace> planes = at_angle;
    for (VertexHalfSpace& plane : planes) {
      // About an axis through (3, 1, -2): levels change, too.
      const Eigen::RowVector3d centre(3, 1, -2);
      const double above = plane.space.level - plane.space.normal.dot(centre);
      plane.space.normal = plane.space.normal * turn.transpose();
      plane.space.level = above + plane.space.normal.dot(centre);
    }
    target.one_sided = OneSidedRowsOf(planes, 0.5);
    return target;
  };
  const auto active = [&](double q) {
    const MuscleTarget target = target_at(q);
    const Eigen::VectorXd depths =
        OneSidedDepths(target.one_sided,
                       FineFromCoarse(model, target.one_sided),
                       SolvedTightly(model, target));
    std::vector<bool> is_active;
    for (const double depth : depths) is_active.push_back(depth > 0);
    return is_active;
  };
  const std::vector<bool> set = active(angle);
  ASSERT_GT(std::count(set.begin(), set.end(), true), 20);
  ASSERT_EQ(set, active(angle - kSolveStep));
  ASSERT_EQ(set, active(angle + kSolveStep));
  ExpectDerivativeOfSolves(model, target_at, angle);
}

// A target that moves as a whole moves the shape as a whole, volume and planes
// included.
TEST(DifferentiateShape, IsRigidWhereTheTargetIs) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget bent = TargetOf(model, BentPose(0.5), {});
  const Points coarse = SolvedTightly(model, bent);
  const Eigen::Vector3d spin(0.3, -0.7, 1.1), velocity(5, -3, 40);
  Eigen::Matrix3d cross;
  cross << 0, -spin.z(), spin.y(), spin.z(), 0, -spin.x(), -spin.y(), spin.x(),
      0;
  const auto turned = [&](const Points& rows) {
    return Points(rows * cross.transpose());
  };
  TargetRate rate;
  rate.linear.laplacian = turned(bent.laplacian);
  rate.linear.skeleton = turned(bent.skeleton);
  rate.linear.skeleton += model.skeleton_weights * velocity.transpose();
  rate.linear.attachment = bent.attachment;  // there are none
  rate.linear.bending = turned(bent.bending);
  rate.plane_turns.resize(0, 3);
  Points expected = turned(coarse);
  expected.rowwise() += velocity.transpose();
  const Points fine = Product(model.fine_from_coarse, coarse);
  const ShapeRate shape =
      DifferentiateShape(model, bent, coarse, fine, {rate})[0];
  EXPECT_LT((shape.coarse - expected).rowwise().norm().maxCoeff(), 1e-4);
}

TEST(DifferentiateShape, NothingMovesWhereTheTargetStands) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.5), {});
  TargetRate still;
  still.linear.laplacian = 0 * target.laplacian;
  still.linear.skeleton = 0 * target.skeleton;
  still.linear.attachment = target.attachment;
  still.linear.bending = 0 * target.bending;
  still.plane_turns.resize(0, 3);
  const Points coarse = SolvedTightly(model, target);
  const Points fine = Product(model.fine_from_coarse, coarse);
  const ShapeRate rate =
      DifferentiateShape(model, target, coarse, fine, {still})[0];
  EXPECT_TRUE(rate.is_converged);
  EXPECT_EQ(rate.iterations, 0);
  EXPECT_EQ(rate.coarse, Points::Zero(model.coarse_rest.rows(), 3));
  EXPECT_EQ(rate.fine, Points::Zero(model.fine_rest.rows(), 3));
}

}  // namespace
}  // namespace musclewarp
