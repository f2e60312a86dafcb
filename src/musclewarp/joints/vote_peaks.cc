// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/vote_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "musclewarp/joints/point_search.h"

namespace musclewarp {
namespace {

using Cell = std::array<int, 3>;

struct CellVotes {
  int count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
};

// The means of the votes in the cells of a grid that hold the most.
std::vector<Eigen::Vector3d> FullestCells(const Points& votes,
                                          double edge,
                                          size_t most) {
  std::map<Cell, CellVotes> cells;
  for (int i = 0; i < votes.rows(); ++i) {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<int>(std::floor(votes(i, axis) / edge));
    }
    CellVotes& held = cells[cell];
    ++held.count;
    held.sum += votes.row(i).transpose();
  }
  std::vector<CellVotes> fullest;
  for (const auto& [cell, held] : cells) fullest.push_back(held);
  std::stable_sort(fullest.begin(), fullest.end(), [](auto& a, auto& b) {
    return a.count > b.count;
  });
  if (fullest.size() > most) fullest.resize(most);
  std::vector<Eigen::Vector3d> means;
  for (const CellVotes& held : fullest) means.push_back(held.sum / held.count);
  return means;
}

// Follows the mean of the votes around a place (mean shift).
VotePeak ClimbFrom(Eigen::Vector3d place,
                   const Points& votes,
                   const PointSearch& search,
                   double radius) {
  constexpr int kMaxMoves = 10;  // mean shift slows down at the top
  VotePeak peak;
  for (int move = 0; move < kMaxMoves; ++move) {
    const std::vector<int> near = search.Within(place, radius);
    const int count = static_cast<int>(near.size());
    if (count < peak.votes || (move > 0 && place == peak.place)) break;
    peak = {place, count};
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int vote : near) sum += votes.row(vote).transpose();
    place = sum / count;
  }
  return peak;
}

}  // namespace

std::vector<VotePeak> FindVotePeaks(const Points& votes,
                                    double radius,
                                    int most) {
  // A peak may be spread over several cells.
  constexpr int kCellsPerPeak = 4;
  const PointSearch search(votes);
  std::vector<VotePeak> found;
  for (const Eigen::Vector3d& start :
       FullestCells(votes, radius, kCellsPerPeak * most)) {
    found.push_back(ClimbFrom(start, votes, search, radius));
  }
  std::stable_sort(found.begin(), found.end(), [](auto& a, auto& b) {
    return a.votes > b.votes;
  });
  std::vector<VotePeak> peaks;
  for (const VotePeak& peak : found) {
    const bool is_apart =
        std::all_of(peaks.begin(), peaks.end(), [&](const VotePeak& other) {
          return (other.place - peak.place).norm() >= radius;
        });
    if (is_apart && static_cast<int>(peaks.size()) < most) {
      peaks.push_back(peak);
    }
  }
  return peaks;
}

}  // namespace musclewarp
