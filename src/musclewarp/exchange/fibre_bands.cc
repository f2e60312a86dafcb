// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/fibre_bands.h"

#include <glog/logging.h>

#include <algorithm>
#include <utility>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

constexpr int kPlaces = 10;
constexpr int kMostRounds = 100;

// Returns ten points of each line, a row each.
Eigen::MatrixXd PlacesOf(const std::vector<Points>& lines) {
  Eigen::MatrixXd rows(lines.size(), 3 * kPlaces);
  for (size_t i = 0; i < lines.size(); ++i) {
    const Points places = Resampled(lines[i], kPlaces);
    for (int k = 0; k < kPlaces; ++k) {
      rows.block<1, 3>(static_cast<Eigen::Index>(i), 3 * k) = places.row(k);
    }
  }
  return rows;
}

// Returns the centre that is nearest to a row.
int NearestCentre(const Eigen::RowVectorXd& row,
                  const Eigen::MatrixXd& centres) {
  Eigen::Index nearest = 0;
  (centres.rowwise() - row).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

// The first centre is the fibre farthest from the mean, each next one that
// which is farthest from all centres.
Eigen::MatrixXd FirstCentres(const Eigen::MatrixXd& rows, int count) {
  Eigen::VectorXd distances =
      (rows.rowwise() - rows.colwise().mean()).rowwise().squaredNorm();
  Eigen::MatrixXd centres(count, rows.cols());
  for (int c = 0; c < count; ++c) {
    Eigen::Index farthest = 0;
    distances.maxCoeff(&farthest);
    centres.row(c) = rows.row(farthest);
    const Eigen::VectorXd from_it =
        (rows.rowwise() - centres.row(c)).rowwise().squaredNorm();
    distances = c == 0 ? from_it : distances.cwiseMin(from_it).eval();
  }
  return centres;
}

}  // namespace

std::vector<std::vector<int>> FibreBands(const std::vector<Points>& fibres,
                                         int count) {
  const auto num_fibres = static_cast<int>(fibres.size());
  count = std::min(count, num_fibres);
  if (count < 1) return {};
  const Eigen::MatrixXd rows = PlacesOf(fibres);
  Eigen::MatrixXd centres = FirstCentres(rows, count);
  std::vector<std::vector<int>> bands;
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<std::vector<int>> next(count);
    for (int i = 0; i < num_fibres; ++i) {
      next[NearestCentre(rows.row(i), centres)].push_back(i);
    }
    if (next == bands) break;
    bands = std::move(next);
    for (int c = 0; c < count; ++c) {
      if (!bands[c].empty()) {
        centres.row(c) = rows(bands[c], Eigen::all).colwise().mean();
      }
    }
  }
  // A band is empty where fibres lie on each other.
  bands.erase(std::remove_if(bands.begin(),
                             bands.end(),
                             [](const auto& band) { return band.empty(); }),
              bands.end());
  std::sort(bands.begin(), bands.end());
  return bands;
}

Points MeanFibre(const std::vector<Points>& fibres,
                 const std::vector<int>& band) {
  CHECK(!band.empty());
  Points mean = Points::Zero(kPlaces, 3);
  for (const int fibre : band) {
    CHECK_LT(fibre, static_cast<int>(fibres.size()));
    mean += Resampled(fibres[fibre], kPlaces);
  }
  return mean / static_cast<double>(band.size());
}

int NearestLine(const std::vector<Points>& fibres,
                const std::vector<int>& band,
                const std::vector<Points>& lines) {
  CHECK(!lines.empty());
  return NearestCentre(PlacesOf({MeanFibre(fibres, band)}), PlacesOf(lines));
}

}  // namespace musclewarp
