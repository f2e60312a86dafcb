// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "certificate/mesh_pairs.h"

#include <cmath>
#include <random>
#include <utility>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  MeshPair Next() {
    MeshPair pair;
    pair.a = Shape();
    pair.b = Shape();
    Place(&pair);
    MoveAway(&pair);
    return pair;
  }

 private:
  int Int(int first, int last) {
    return std::uniform_int_distribution<int>(first, last)(random_);
  }
  double Real(double first, double last) {
    return std::uniform_real_distribution<double>(first, last)(random_);
  }
  RowVector3d Vector(double size) {
    return {Real(-size, size), Real(-size, size), Real(-size, size)};
  }

  // Half of the shapes have small integers as coordinates, so that much is in
  // one plane.
  TriangleSoup Shape() {
    TriangleSoup soup;
    switch (Int(0, 3)) {
      case 0:
        soup = UnitTetrahedron();
        soup.points *= Int(1, 4);
        break;
      case 1:
        soup = Box(2 * Int(1, 3), 2 * Int(1, 3), 2 * Int(1, 3));
        break;
      case 2:
        soup = Icosphere(Real(0.5, 3), Int(0, 1));
        break;
      default:
        soup = LatticeBox(Int(1, 2), Int(1, 2), Int(1, 2));
    }
    if (Int(0, 4) == 0) soup.points.col(Int(0, 2)) *= std::exp2(-Int(8, 20));
    if (Int(0, 2) == 0) Turn(&soup);
    return soup;
  }

  void Turn(TriangleSoup* soup) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(Real(-1, 1), Real(-1, 1), Real(-1, 1), Real(0.1, 1))
            .normalized();
    soup->points = Points(soup->points * turn.toRotationMatrix());
  }

  RowVector3d Corner(const TriangleSoup& soup) {
    return soup.points.row(Int(0, static_cast<int>(soup.points.rows()) - 1));
  }

  // A point with simple weights on a triangle.
  RowVector3d OnTriangle(const TriangleSoup& soup) {
    const auto t =
        soup.triangles.row(Int(0, static_cast<int>(soup.triangles.rows()) - 1));
    const double u = Int(0, 4) / 8.0, v = Int(0, 4) / 8.0;
    return (1 - u - v) * soup.points.row(t[0]) + u * soup.points.row(t[1]) +
           v * soup.points.row(t[2]);
  }

  void MoveTo(const RowVector3d& from, const RowVector3d& to, TriangleSoup* b) {
    b->points.rowwise() += to - from;
  }

  void Place(MeshPair* pair) {
    switch (Int(0, 6)) {
      case 0:
        pair->kind = "apart or crossing";
        pair->b.points.rowwise() += Vector(6);
        break;
      case 1:
        pair->kind = "touching";
        MoveTo(Corner(pair->b), OnTriangle(pair->a), &pair->b);
        break;
      case 2:
        pair->kind = "in common planes";
        for (int k = 0; k < 3; ++k) {
          pair->b.points.col(k).array() += Int(-4, 4);
        }
        break;
      case 3:
        pair->kind = "equal";
        pair->b = pair->a;
        break;
      case 4:
        pair->kind = "nested";
        pair->b = pair->a;
        pair->b.points *= std::exp2(-Int(1, 3));
        pair->b.points.rowwise() += Vector(0.2);
        break;
      case 5:
        pair->kind = "a step of the last digit apart";
        pair->b = pair->a;
        pair->b.points.col(0).array() +=
            pair->a.points.col(0).maxCoeff() - pair->a.points.col(0).minCoeff();
        for (Eigen::Index v = 0; v < pair->b.points.rows(); ++v) {
          pair->b.points(v, 0) =
              std::nextafter(pair->b.points(v, 0), Int(0, 3) == 0 ? -1e9 : 1e9);
        }
        break;
      default:
        pair->kind = "turned and near";
        Turn(&pair->b);
        MoveTo(Corner(pair->b), Corner(pair->a), &pair->b);
        pair->b.points.rowwise() += Vector(std::exp2(-Int(0, 45)));
    }
  }

  // Rounding of coordinates far away is part of the test.
  void MoveAway(MeshPair* pair) {
    if (Int(0, 2) != 0) return;
    const RowVector3d by = Vector(9e6);
    pair->kind += ", far away";
    pair->a.points.rowwise() += by;
    pair->b.points.rowwise() += by;
  }

  std::mt19937 random_;
};

}  // namespace

MeshPair RandomMeshPair(unsigned seed) { return Generator(seed).Next(); }

}  // namespace musclewarp
