// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/mean_value_coordinates.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "musclewarp/base/threads.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Required of linear precision, relative to the size of the cage.
constexpr double kLinearPrecision = 1e-10;

class Random {
 public:
  double Uniform(double low, double high) {
    return low + (high - low) * (engine_() / 4294967296.0);
  }
  int Index(int size) { return static_cast<int>(engine_() % size); }
  Eigen::RowVector3d Vector() {
    return {Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1)};
  }

 private:
  std::mt19937 engine_{7};
};

// A spindle with a dent and a shift far from the origin: not convex, of the
// size and place of real muscles.
TriangleSoup DentedCage() {
  TriangleSoup cage = Spindle(40, 150, 2);
  for (Eigen::Index i = 0; i < cage.points.rows(); ++i) {
    if (cage.points(i, 0) > 10) cage.points(i, 0) *= 0.4;
    cage.points(i, 1) += 0.002 * cage.points(i, 2) * cage.points(i, 2);
  }
  cage.points.rowwise() += Eigen::RowVector3d(180, 270, -400);
  return cage;
}

double Size(const TriangleSoup& mesh) {
  return (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff())
      .norm();
}

void ExpectReproduces(const TriangleSoup& cage, const Points& queries) {
  const RowMajorMatrix w =
      MeanValueCoordinates(queries, cage.points, cage.triangles);
  ASSERT_TRUE(w.allFinite());
  // Sums of some hundred coordinates of size 1.
  constexpr double kSum = 1e-12;
  EXPECT_LT((w.rowwise().sum().array() - 1).abs().maxCoeff(), kSum);
  EXPECT_LT((w * cage.points - queries).rowwise().norm().maxCoeff(),
            kLinearPrecision * Size(cage));
}

Eigen::RowVector3d OnFace(const TriangleSoup& cage,
                          int face,
                          double a,
                          double b) {
  return a * cage.points.row(cage.triangles(face, 0)) +
         b * cage.points.row(cage.triangles(face, 1)) +
         (1 - a - b) * cage.points.row(cage.triangles(face, 2));
}

// The definition, by quadrature: w_j is the integral over the sphere of the
// barycentric weight of the first... summed with signs over all faces that the
// direction meets, divided by the distance to the face.
Eigen::RowVectorXd ByQuadrature(const TriangleSoup& cage,
                                const Eigen::RowVector3d& x,
                                int steps) {
  Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(cage.points.rows());
  for (Eigen::Index f = 0; f < cage.triangles.rows(); ++f) {
    const Eigen::RowVector3d a = cage.points.row(cage.triangles(f, 0)) - x;
    const Eigen::RowVector3d b = cage.points.row(cage.triangles(f, 1)) - x;
    const Eigen::RowVector3d c = cage.points.row(cage.triangles(f, 2)) - x;
    const Eigen::RowVector3d normal = (b - a).cross(c - a);  // 2 area
    // Midpoint rule on steps^2 small triangles; the solid angle of an area
    // element at p is (p . n) / |p|^3, and the weight has one more 1 / |p|.
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; j < 2 * (steps - i) - 1; ++j) {
        const bool is_up = j % 2 == 0;
        const double u = (i + (is_up ? 1 / 3.0 : 2 / 3.0)) / steps;
        const int row = j / 2;
        const double v = (row + (is_up ? 1 / 3.0 : 2 / 3.0)) / steps;
        const Eigen::RowVector3d p = (1 - u - v) * a + u * b + v * c;
        const double weight =
            p.dot(normal) / (2.0 * steps * steps) / std::pow(p.norm(), 4);
        weights[cage.triangles(f, 0)] += weight * (1 - u - v);
        weights[cage.triangles(f, 1)] += weight * u;
        weights[cage.triangles(f, 2)] += weight * v;
      }
    }
  }
  return weights / weights.sum();
}

}  // namespace

TEST(MeanValueCoordinates, ReproducePointsInsideAndOutside) {
  const TriangleSoup cage = DentedCage();
  Random random;
  Points queries(4000, 3);
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    const double reach = i % 2 == 0 ? 150 : 800;
    queries.row(i) =
        Eigen::RowVector3d(180, 270, -400) + reach * random.Vector();
  }
  ExpectReproduces(cage, queries);
}

TEST(MeanValueCoordinates, AreTheIdentityAtVertices) {
  // The coordinates are 0 and 1 before the sum and the query are corrected.
  constexpr double kCorrection = 1e-12;
  const TriangleSoup cage = DentedCage();
  const RowMajorMatrix w =
      MeanValueCoordinates(cage.points, cage.points, cage.triangles);
  EXPECT_LT(
      (w - RowMajorMatrix::Identity(w.rows(), w.cols())).cwiseAbs().maxCoeff(),
      kCorrection);
}

TEST(MeanValueCoordinates, AreBarycentricOnFacesAndEdges) {
  const TriangleSoup cage = DentedCage();
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const int face = random.Index(cage.triangles.rows());
    const double a = random.Uniform(0, 1);
    const double b = i % 2 == 0 ? 0 : random.Uniform(0, 1 - a);
    Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(cage.points.rows());
    expected[cage.triangles(face, 0)] = a;
    expected[cage.triangles(face, 1)] = b;
    expected[cage.triangles(face, 2)] = 1 - a - b;
    Points query(1, 3);
    query.row(0) = OnFace(cage, face, a, b);
    // The rounding of the query, 1e-13 mm, over the shortest edge, and its
    // logarithm beside an edge.
    constexpr double kBesideEdge = 1e-10;
    EXPECT_LT(
        (MeanValueCoordinates(query, cage.points, cage.triangles) - expected)
            .cwiseAbs()
            .maxCoeff(),
        kBesideEdge)
        << "face " << face << " a " << a << " b " << b;
  }
}

TEST(MeanValueCoordinates, ReproducePointsNextToTheCage) {
  const TriangleSoup cage = DentedCage();
  Random random;
  for (double distance = 1e-15; distance < 0.1; distance *= 10) {
    Points queries(600, 3);
    for (Eigen::Index i = 0; i < queries.rows(); ++i) {
      const int face = random.Index(cage.triangles.rows());
      const double a = i % 3 == 0 ? 1 : random.Uniform(0, 1);
      const double b = i % 3 == 1 ? 0 : random.Uniform(0, 1 - a);
      queries.row(i) =
          OnFace(cage, face, a, b) + distance * Size(cage) * random.Vector();
    }
    ExpectReproduces(cage, queries);
  }
}

TEST(MeanValueCoordinates, ReproducePointsInThePlaneOfAFace) {
  const TriangleSoup cage = DentedCage();
  Random random;
  Points queries(3000, 3);
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    queries.row(i) = OnFace(cage,
                            random.Index(cage.triangles.rows()),
                            random.Uniform(-5, 5),
                            random.Uniform(-5, 5));
  }
  ExpectReproduces(cage, queries);
  // Many faces of a box share the planes of its grid.
  const TriangleSoup box = Box(2, 3, 4);
  Points corners(125, 3);
  for (int i = 0; i < 125; ++i) {
    const int row = i / 5 % 5;
    const int layer = i / 25;
    corners.row(i) << i % 5 - 2, (row - 2) * 1.5, (layer - 2) * 2.0;
  }
  ExpectReproduces(box, corners);
}

TEST(MeanValueCoordinates, BesideADiagonalAreThoseOfTheTriangleTheyAreIn) {
  const TriangleSoup box = Box(2, 3, 4);
  // The upper side, whose diagonal runs from corner 4 to corner 7. A point is
  // `aside` of it towards corner 5 or 6.
  for (const double aside : {1e-4, 1e-6, 1e-7, 1e-8}) {
    for (const int corner : {5, 6}) {
      for (const double along : {0.2, 0.5, 0.7}) {
        Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(8);
        expected[4] = 1 - along - aside;
        expected[7] = along;
        expected[corner] = aside;
        const Points query = expected * box.points;
        // What the coordinates near an edge lose: the rounding of the point,
        // 1e-16, times the logarithm of the distance.
        constexpr double kBesideDiagonal = 1e-12;
        EXPECT_LT(
            (MeanValueCoordinates(query, box.points, box.triangles) - expected)
                .cwiseAbs()
                .maxCoeff(),
            kBesideDiagonal)
            << aside << " towards " << corner;
      }
    }
  }
}

// Where a triangle is seen nearly edge on, the weights lose digits, and what is
// reproduced has them all the same.
TEST(MeanValueCoordinates, ReproducePointsBesideAPlaneToTheLastDigits) {
  const TriangleSoup cage = Icosphere(50, 2);
  Random random;
  for (const double beside : {1e-10, 1e-9, 1e-8, 1e-7}) {
    Points queries(1000, 3);
    for (Eigen::Index i = 0; i < queries.rows(); ++i) {
      queries.row(i) = OnFace(cage,
                              random.Index(320),
                              random.Uniform(-5, 5),
                              random.Uniform(-5, 5)) +
                       beside * random.Vector();
    }
    const RowMajorMatrix w =
        MeanValueCoordinates(queries, cage.points, cage.triangles);
    // Sums of 162 products of up to 50 mm with coordinates of size 1.
    constexpr double kSumOfProducts = 1e-12;
    EXPECT_LT((w * cage.points - queries).cwiseAbs().maxCoeff(), kSumOfProducts)
        << beside;
  }
}

TEST(MeanValueCoordinates, AreContinuousAcrossTheCage) {
  const TriangleSoup cage = DentedCage();
  Random random;
  for (int i = 0; i < 300; ++i) {
    const int face = random.Index(cage.triangles.rows());
    const double a = random.Uniform(0, 1);
    const double b = i % 2 == 0 ? 0 : random.Uniform(0, 1 - a);
    Points near(5, 3);
    for (int k = 0; k < 5; ++k) {
      // 0, then from 1e-13 up to 1e-10 of the size away.
      near.row(k) =
          OnFace(cage, face, a, b) +
          (k == 0 ? 0 : std::pow(10, k - 14)) * Size(cage) * random.Vector();
    }
    const RowMajorMatrix w =
        MeanValueCoordinates(near, cage.points, cage.triangles);
    // The slope of the coordinates grows as the logarithm of the distance to an
    // edge: 1e-10 of the size over edges a tenth of it, times 25.
    constexpr double kChange = 1e-7;
    EXPECT_LT((w.rowwise() - w.row(0)).cwiseAbs().maxCoeff(), kChange);
  }
}

TEST(MeanValueCoordinates, BearSlivers) {
  for (const double height : {1e-2, 1e-5, 1e-8, 1e-12, 0.0}) {
    // A vertex moved almost onto the edge across makes slivers around it.
    TriangleSoup cage = Icosphere(50, 1);
    const int a = cage.triangles(0, 0);
    const int b = cage.triangles(0, 1);
    const int c = cage.triangles(0, 2);
    const Eigen::RowVector3d middle =
        (cage.points.row(a) + cage.points.row(b)) / 2;
    cage.points.row(c) = middle + height * (cage.points.row(c) - middle);
    Random random;
    Points queries(600, 3);
    for (Eigen::Index i = 0; i < queries.rows(); ++i) {
      const double reach = i % 3 == 0 ? 100 : i % 3 == 1 ? 1e-3 : 1e-9;
      queries.row(i) = middle + reach * random.Vector();
    }
    ExpectReproduces(cage, queries);
  }
}

TEST(MeanValueCoordinates, AgreeWithTheIntegralThatDefinesThem) {
  const TriangleSoup cage = Spindle(3, 6, 1);
  Points queries(3, 3);
  queries << 0.3, -0.2, 0.8, 1, 0.5, -2, 0, 0, 1.5;
  const RowMajorMatrix w =
      MeanValueCoordinates(queries, cage.points, cage.triangles);
  for (Eigen::Index q = 0; q < queries.rows(); ++q) {
    // The midpoint rule converges with the square of its 64 steps.
    EXPECT_LT((w.row(q) - ByQuadrature(cage, queries.row(q), 64))
                  .cwiseAbs()
                  .maxCoeff(),
              2e-4);
  }
}

TEST(MeanValueCoordinates, ArePositiveInsideAConvexCage) {
  const TriangleSoup cage = Icosphere(10, 2);
  Random random;
  Points queries(1000, 3);
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    queries.row(i) = 5.5 * random.Vector();
  }
  EXPECT_GT(
      MeanValueCoordinates(queries, cage.points, cage.triangles).minCoeff(), 0);
}

TEST(MeanValueCoordinates, DoNotDependOnPlaceTurnAndScale) {
  const TriangleSoup cage = Spindle(3, 6, 1);
  Random random;
  Points queries(200, 3);
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    queries.row(i) = 8 * random.Vector();
  }
  // Moved coordinates are rounded by 1e-14 of the size; the worst of the
  // queries are near the cage and magnify that.
  constexpr double kSimilarity = 1e-10;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  const auto moved = [&](const Points& points) {
    Points result = 20 * points * turn.transpose();
    result.rowwise() += Eigen::RowVector3d(50, -60, 70);
    return result;
  };
  EXPECT_LT(
      (MeanValueCoordinates(queries, cage.points, cage.triangles) -
       MeanValueCoordinates(moved(queries), moved(cage.points), cage.triangles))
          .cwiseAbs()
          .maxCoeff(),
      kSimilarity);
}

TEST(MeanValueCoordinates, DoNotDependOnTheNumberOfThreads) {
  const TriangleSoup cage = DentedCage();
  const Points queries = Spindle(20, 100, 3).points;
  const int threads = NumThreads();
  SetNumThreads(1);
  const RowMajorMatrix one =
      MeanValueCoordinates(queries, cage.points, cage.triangles);
  SetNumThreads(3);
  const RowMajorMatrix three =
      MeanValueCoordinates(queries, cage.points, cage.triangles);
  SetNumThreads(threads);
  EXPECT_EQ(one, three);
}

}  // namespace musclewarp
