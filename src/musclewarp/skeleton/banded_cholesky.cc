// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace musclewarp {

bool FactorBand(SymmetricBand* a) {
  const Eigen::Index width = a->rows() - 1, count = a->cols();
  for (Eigen::Index j = 0; j < count; ++j) {
    auto column = a->col(j);
    if (!(column[0] > 0)) return false;
    const Eigen::Index below = std::min(width, count - 1 - j);
    column[0] = std::sqrt(column[0]);
    column.segment(1, below) /= column[0];
    for (Eigen::Index k = 1; k <= below; ++k) {
      if (column[k] == 0) continue;
      a->col(j + k).head(below - k + 1) -=
          column[k] * column.segment(k, below - k + 1);
    }
  }
  return true;
}

void SolveBand(const SymmetricBand& factor, Eigen::VectorXd* b) {
  const Eigen::Index width = factor.rows() - 1, count = factor.cols();
  for (Eigen::Index j = 0; j < count; ++j) {
    const Eigen::Index below = std::min(width, count - 1 - j);
    (*b)[j] /= factor(0, j);
    b->segment(j + 1, below) -= (*b)[j] * factor.col(j).segment(1, below);
  }
  for (Eigen::Index j = count - 1; j >= 0; --j) {
    const Eigen::Index below = std::min(width, count - 1 - j);
    (*b)[j] -= factor.col(j).segment(1, below).dot(b->segment(j + 1, below));
    (*b)[j] /= factor(0, j);
  }
}

}  // namespace musclewarp
