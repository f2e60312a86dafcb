// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How a deformation stretches and bends a surface at each of its vertices, #V
// entries each. A rigid motion has stretches and areas of 1 and no bend.
struct SurfaceDeformation {
  // The largest ratio of a length after to its length before, in any direction
  // on the surface: the larger singular value of the deformation gradient.
  Eigen::VectorXd largest_stretch;

  // The same ratio along the course of the muscle, and across it. 1 where no
  // course is given.
  Eigen::VectorXd stretch_along, stretch_across;

  // The ratio of the areas around the vertex.
  Eigen::VectorXd area_ratio;

  // By how much the angle between the normals of the vertex and of a neighbour
  // changes, at most, rad. Convex angles count positive, so that a bend that
  // turns from convex to concave is their sum.
  Eigen::VectorXd bend;
};

// What the measures need of the surface at rest, computed once for all poses.
//
// The deformation gradient of a vertex is the linear map from its tangent plane
// at rest to that after, which fits the edges around it best (least squares),
// so that a single thin triangle does not decide it. Vertices whose edges lie
// almost on one line have no gradient: they count as rigid.
class SurfaceAtRest {
 public:
  // `points`: the vertices at rest (#V x 3, mm), `triangles`: #F x 3. `course`
  // (#V x 3, or without rows) has the direction of the muscle's course at each
  // vertex, of any length; zero where there is none.
  SurfaceAtRest(const Points& points,
                const Triangles& triangles,
                const Points& course);

  const Points& points() const { return points_; }
  const Triangles& triangles() const { return triangles_; }

  // Compares the surface with itself at rest. `deformed`: #V x 3, mm.
  SurfaceDeformation Measure(const Points& deformed) const;

 private:
  using PlaneVector = Eigen::Vector2d;
  using Gradient = Eigen::Matrix<double, 3, 2>;

  void FindNeighbours();
  void FitGradients(const Points& normals, const Points& course);
  Gradient GradientAt(Eigen::Index v, const Points& deformed) const;
  Eigen::VectorXd Bends(const Points& deformed, const Points& normals) const;

  Points points_;
  Triangles triangles_;

  // The neighbours of vertex v are the entries from first_[v] on, each with the
  // number of triangles at the edge to it, and with what the gradient of v owes
  // to the edge: it is the sum of (deformed edge) share^T.
  std::vector<int> first_, neighbours_, num_triangles_;
  std::vector<PlaneVector> shares_;
  std::vector<char> has_gradient_, has_course_;  // #V

  // The angle between the normals of v and of a larger neighbour, rad, by
  // neighbour.
  std::vector<double> angles_;
};

}  // namespace musclewarp
