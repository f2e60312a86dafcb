// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/paper_contact/contact_body.h"

namespace musclewarp {

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
