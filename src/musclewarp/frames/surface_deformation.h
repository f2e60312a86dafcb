// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

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

// Compares a surface with itself at rest. `rest` and `deformed` are the
// positions of the same vertices (#V x 3, mm), `triangles` is #F x 3. `course`
// (#V x 3, or without rows) has the direction of the muscle's course at each
// vertex in the rest pose, of any length; zero where there is none.
//
// The deformation gradient of a vertex is the linear map from its tangent plane
// at rest to that after, which fits the edges around it best (least squares),
// so that a single thin triangle does not decide it. Vertices whose edges lie
// almost on one line have no gradient: they count as rigid.
SurfaceDeformation MeasureSurfaceDeformation(const Points& rest,
                                             const Points& deformed,
                                             const Triangles& triangles,
                                             const Points& course);

}  // namespace musclewarp
