// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// The shape of a muscle approaches a limit as its hull becomes finer: the
// distances between successive densities fall with the square of the length of
// the edges.
#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/solver/gauss_newton.h"
#include "musclewarp/solver/muscle_model.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kHalfLength = 50;  // mm

// A slab along z, 20 mm wide, 10 mm thick and 100 mm long, with edges of
// 10 mm / n. All densities have the same surface.
TriangleSoup Slab(int n) {
  TriangleSoup slab = LatticeBox(n, 2 * n, 10 * n);
  slab.points *= 10.0 / n;
  slab.points.rowwise() -= Eigen::RowVector3d(5, 10, kHalfLength);
  return slab;
}

// A cylinder along z, 20 mm thick and 100 mm long: a box whose sections are
// widened to discs. All vertices lie on the cylinder, with edges of about
// 20 mm / n.
TriangleSoup Cylinder(int n) {
  TriangleSoup cylinder = LatticeBox(n, n, 5 * n);
  cylinder.points *= 20.0 / n;
  cylinder.points.rowwise() -= Eigen::RowVector3d(10, 10, kHalfLength);
  for (Eigen::Index i = 0; i < cylinder.points.rows(); ++i) {
    auto across = cylinder.points.row(i).head<2>();
    const double radius = across.cwiseAbs().maxCoeff();
    if (radius > 0) across *= radius / across.norm();
  }
  return cylinder;
}

// A muscle with a line along its middle, of many points.
SceneMuscle MuscleAlongZ() {
  constexpr int kPoints = 33;
  ActionLine line;
  line.name = "middle";
  line.rest = Points::Zero(kPoints, 3);
  line.rest.col(2) =
      Eigen::VectorXd::LinSpaced(kPoints, 5 - kHalfLength, kHalfLength - 5);
  SceneMuscle muscle;
  muscle.name = "muscle";
  muscle.lines = {line};
  return muscle;
}

// The line of MuscleAlongZ() bent to a circular arc in the plane of x and z.
ScenePose BentToArc(double angle) {
  Points points = MuscleAlongZ().lines[0].rest;
  const double radius = 2 * (kHalfLength - 5) / angle;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double turn = points(i, 2) / radius;
    points.row(i) << radius * (1 - std::cos(turn)), 0, radius * std::sin(turn);
  }
  ScenePose pose;
  pose.lines["middle"] = points;
  return pose;
}

struct ShapeLimitCase {
  const char* name;
  TriangleSoup (*body)(int n);
  int coarsest;  // density
};

class ShapeLimit : public ::testing::TestWithParam<ShapeLimitCase> {
 protected:
  // Returns the bent fine vertices. The muscle is the same at all densities:
  // the finest body, of which a layer is taken off.
  static Points Bent(int density) {
    const auto& [name, body, coarsest] = GetParam();
    TriangleSoup fine = body(4 * coarsest);
    fine.points *= 0.85;
    const MuscleModel model =
        PrepareMuscle(MuscleAlongZ(), fine, body(density), {}, {});
    Points coarse = model.coarse_rest;
    SolverSummary summary;
    SolveGaussNewton(
        model, TargetOf(model, BentToArc(1.2), {}), {}, &coarse, &summary);
    EXPECT_TRUE(summary.IsSolutionUsable()) << summary.BriefReport();
    return Product(model.fine_from_coarse, coarse);
  }
};

double RootMeanSquare(const Points& differences) {
  return differences.norm() /
         std::sqrt(static_cast<double>(differences.rows()));
}

TEST_P(ShapeLimit, DistancesFallWithTheSquareOfTheEdges) {
  const int n = GetParam().coarsest;
  const Points shape = Bent(n);
  const Points finer = Bent(2 * n);
  const Points finest = Bent(4 * n);
  const double first = RootMeanSquare(finer - shape);
  const double second = RootMeanSquare(finest - finer);
  // Four times, were it not for edges that are still long.
  EXPECT_GT(first / second, 3.5);
  EXPECT_LT(second, 0.05);
}

INSTANTIATE_TEST_SUITE_P(
    Bodies,
    ShapeLimit,
    ::testing::Values(ShapeLimitCase{"slab", Slab, 1},
                      ShapeLimitCase{"cylinder", Cylinder, 2}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace musclewarp
