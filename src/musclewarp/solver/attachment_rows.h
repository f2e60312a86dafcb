// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The fine vertices that attachment rows tie to a body, and the weights of
// their rows, the squares of which add up to 1. Attachment rows go beyond the
// paper: they make the area where a muscle is attached follow its bone
// (docs/method.md). Each row is dense, so that more of them than some dozens
// cost time without changing the shape.
struct AttachmentRows {
  std::vector<int> vertices;
  std::vector<double> weights;
};

// Returns rows of equal weight for the vertices in `points` (#V x 3, rest pose,
// mm) within the radius of `attachment`. If there are more than `max_rows` of
// them, every so-many-th is kept, so that exactly `max_rows` remain.
// Precondition: max_rows is above 0.
AttachmentRows EqualRows(const Attachment& attachment,
                         const Points& points,
                         int max_rows);

// Returns at most `max_rows` rows whose vertices are spread evenly over the
// area of `attachment`. The square of a weight is the fraction of that area
// which is nearer to its vertex than to the others. `areas` are those of the
// vertices, #V, mm^2. A finer mesh thus has the same rows, to the distance of
// its vertices. Precondition: max_rows is above 0.
AttachmentRows RowsByArea(const Attachment& attachment,
                          const Points& points,
                          const Eigen::VectorXd& areas,
                          int max_rows);

}  // namespace musclewarp
