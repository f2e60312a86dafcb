// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/paper_contact/contact_body.h"
#include "support/meshes.h"

namespace musclewarp {

// Rounding of coordinates of size 10.
constexpr double kCoordinateRounding = 1e-12;

// A box of 6 x 6 x 4 mm with a corner at the origin.
inline TriangleSoup LowerBox() { return LatticeBox(6, 6, 4); }

// The same with its lower side at z, shifted so that no vertex is above another
// one of the lower box.
inline TriangleSoup UpperBox(double z) {
  return MovedBy(LowerBox(), {0.25, 0.25, z});
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
