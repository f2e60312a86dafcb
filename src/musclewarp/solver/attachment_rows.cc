// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/attachment_rows.h"

#include <cmath>

#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {

AttachmentRows EqualRows(const Attachment& attachment,
                         const Points& points,
                         int max_rows) {
  AttachmentRows rows;
  rows.vertices = VerticesInArea(attachment, points);
  const size_t found = rows.vertices.size();
  if (found > static_cast<size_t>(max_rows)) {
    std::vector<int> thinned(max_rows);
    for (int i = 0; i < max_rows; ++i) {
      thinned[i] = rows.vertices[i * found / max_rows];
    }
    rows.vertices = std::move(thinned);
  }
  rows.weights.assign(rows.vertices.size(),
                      1 / std::sqrt(static_cast<double>(rows.vertices.size())));
  return rows;
}

AttachmentRows RowsByArea(const Attachment& attachment,
                          const Points& points,
                          const Eigen::VectorXd& areas,
                          int max_rows) {
  const std::vector<int> found = VerticesInArea(attachment, points);
  AttachmentRows rows;
  if (found.empty()) return rows;
  const Points area = points(found, Eigen::all);
  const std::vector<int> chosen = SpreadPoints(area, max_rows);
  std::vector<double> squares(chosen.size(), 0);
  double sum = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    Eigen::Index nearest;
    (area(chosen, Eigen::all).rowwise() - area.row(i))
        .rowwise()
        .squaredNorm()
        .minCoeff(&nearest);
    squares[nearest] += areas[found[i]];
    sum += areas[found[i]];
  }
  for (size_t k = 0; k < chosen.size(); ++k) {
    rows.vertices.push_back(found[chosen[k]]);
    rows.weights.push_back(std::sqrt(squares[k] / sum));
  }
  return rows;
}

}  // namespace musclewarp
