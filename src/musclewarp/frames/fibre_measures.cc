// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/fibre_measures.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

constexpr int kFifths = 5;

// The root mean square distance of points from their mean.
double SpreadOfPoints(const Points& points) {
  const Points apart = points.rowwise() - points.colwise().mean();
  return std::sqrt(apart.rowwise().squaredNorm().mean());
}

// Adds the length of a segment, which lies on the shares from `begin` to `end`
// of a fibre, to the fifths that it lies in.
void AddLength(double begin,
               double end,
               double length,
               std::array<double, kFifths>* fifths) {
  if (end <= begin) return;
  for (int i = 0; i < kFifths; ++i) {
    const double first = std::max(begin, i / double{kFifths});
    const double last = std::min(end, (i + 1) / double{kFifths});
    if (last > first) (*fifths)[i] += length * (last - first) / (end - begin);
  }
}

}  // namespace

FibreSpread SpreadOf(const std::vector<Points>& fibres) {
  FibreSpread spread;
  if (fibres.empty()) return spread;
  Points origins(fibres.size(), 3), insertions(fibres.size(), 3);
  spread.shortest = PolylineLength(fibres[0]);
  for (size_t i = 0; i < fibres.size(); ++i) {
    spread.shortest = std::min(spread.shortest, PolylineLength(fibres[i]));
    origins.row(i) = fibres[i].row(0);
    insertions.row(i) = fibres[i].row(fibres[i].rows() - 1);
  }
  spread.at_origin = SpreadOfPoints(origins);
  spread.at_insertion = SpreadOfPoints(insertions);
  return spread;
}

std::array<double, kFifths> StretchByFifths(const std::vector<Points>& rest,
                                            const std::vector<Points>& fibres) {
  CHECK_EQ(rest.size(), fibres.size());
  std::array<double, kFifths> sums = {};
  int count = 0;
  for (size_t k = 0; k < fibres.size(); ++k) {
    const double length = PolylineLength(rest[k]);
    if (!(length > 0)) continue;
    const Eigen::VectorXd shares = SharesAlong(rest[k]);
    std::array<double, kFifths> lengths = {};
    for (Eigen::Index i = 1; i < shares.size(); ++i) {
      AddLength(shares[i - 1],
                shares[i],
                (fibres[k].row(i) - fibres[k].row(i - 1)).norm(),
                &lengths);
    }
    for (int i = 0; i < kFifths; ++i) sums[i] += kFifths * lengths[i] / length;
    ++count;
  }
  if (count == 0) sums.fill(1);
  for (double& sum : sums) sum /= std::max(1, count);
  return sums;
}

}  // namespace musclewarp
