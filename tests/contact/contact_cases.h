// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "musclewarp/contact/contact_body.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Small meshes that meet, like the figures of paper section 3.

// The box [0, nx] x [0, ny] x [0, nz] with a lattice of points a unit apart on
// its sides, so that several vertices of a side may be inside another body.
TriangleSoup LatticeBox(int nx, int ny, int nz);

inline TriangleSoup MovedBy(TriangleSoup soup, const Eigen::RowVector3d& by) {
  soup.points.rowwise() += by;
  return soup;
}

// A shape and a body of it that keep together.
struct LoneBody {
  LoneBody(TriangleSoup soup, bool is_deformable)
      : shape("body", std::move(soup), 1),
        body(is_deformable
                 ? ContactBody::Deformable(shape, 1)
                 : ContactBody::Obstacle(shape, Eigen::Matrix4d::Identity())) {}
  LoneBody(const LoneBody&) = delete;

  ContactShape shape;
  ContactBody body;
};

}  // namespace musclewarp
