// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/vote_peaks.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kPeakRadius = 2;

// Votes spread by at most `spread` along each axis about a place.
Points VotesAbout(const Eigen::RowVector3d& place,
                  double spread,
                  int count,
                  int seed) {
  return (spread * RandomPoints(count, seed)).rowwise() + place;
}

Points AllOf(const std::vector<Points>& parts) {
  Points all(0, 3);
  for (const Points& part : parts) {
    all.conservativeResize(all.rows() + part.rows(), 3);
    all.bottomRows(part.rows()) = part;
  }
  return all;
}

// Three clusters among votes that are spread over a cube of 100 mm.
Points ThreeClusters() {
  return AllOf({VotesAbout({0, 0, 0}, 50, 1000, 1),
                VotesAbout({20, 10, -5}, 0.8, 60, 2),
                VotesAbout({-30, 0, 12}, 0.8, 100, 3),
                VotesAbout({5, -25, 30}, 0.8, 30, 4)});
}

TEST(VotePeaks, AreWhereMostVotesMeetTheLargestFirst) {
  const std::vector<VotePeak> peaks =
      FindVotePeaks(ThreeClusters(), kPeakRadius, 3);
  ASSERT_EQ(peaks.size(), 3u);
  // The mean of n votes spread evenly over +-0.8 mm is off by 0.8 / sqrt(3 n)
  // along each axis: 0.08 mm for 30 votes; four times that in space.
  constexpr double kTolerance = 0.35;
  EXPECT_LT((peaks[0].place - Eigen::Vector3d(-30, 0, 12)).norm(), kTolerance);
  EXPECT_LT((peaks[1].place - Eigen::Vector3d(20, 10, -5)).norm(), kTolerance);
  EXPECT_LT((peaks[2].place - Eigen::Vector3d(5, -25, 30)).norm(), kTolerance);
  EXPECT_GE(peaks[0].votes, 100);
  EXPECT_GE(peaks[1].votes, 60);
  EXPECT_GE(peaks[2].votes, 30);
}

TEST(VotePeaks, HaveAsManyVotesAsLieAroundThem) {
  const Points votes = ThreeClusters();
  const std::vector<VotePeak> peaks = FindVotePeaks(votes, kPeakRadius, 8);
  ASSERT_EQ(peaks.size(), 8u);
  for (size_t i = 0; i < peaks.size(); ++i) {
    int around = 0;
    for (const auto& vote : votes.rowwise()) {
      around += (vote.transpose() - peaks[i].place).norm() <= kPeakRadius;
    }
    EXPECT_EQ(peaks[i].votes, around);
    if (i > 0) {
      EXPECT_LE(peaks[i].votes, peaks[i - 1].votes);
    }
  }
}

TEST(VotePeaks, AreAtLeastTheRadiusApart) {
  // A cluster wider than the radius has several peaks, which are near each
  // other.
  const Points votes = VotesAbout({0, 0, 0}, 4, 2000, 5);
  const std::vector<VotePeak> peaks = FindVotePeaks(votes, kPeakRadius, 6);
  ASSERT_GT(peaks.size(), 1u);
  for (size_t i = 0; i < peaks.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GE((peaks[i].place - peaks[j].place).norm(), kPeakRadius);
    }
  }
}

TEST(VotePeaks, AreNoMoreThanWanted) {
  const Points votes = ThreeClusters();
  EXPECT_EQ(FindVotePeaks(votes, kPeakRadius, 1).size(), 1u);
  EXPECT_EQ(FindVotePeaks(votes, kPeakRadius, 1)[0].votes,
            FindVotePeaks(votes, kPeakRadius, 5)[0].votes);
}

// The cells in which votes are counted first meet at the origin, which divides
// a cluster there among eight of them.
TEST(VotePeaks, AreFoundWhereCellsMeet) {
  const Points votes = AllOf({VotesAbout({0, 0, 0}, 0.8, 80, 6),
                              VotesAbout({21, 21, 21}, 0.8, 40, 7)});
  const std::vector<VotePeak> peaks = FindVotePeaks(votes, kPeakRadius, 2);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_EQ(peaks[0].votes, 80);
  EXPECT_EQ(peaks[1].votes, 40);
  EXPECT_LT(peaks[0].place.norm(), 1);
}

TEST(VotePeaks, AreNoneWithoutVotes) {
  EXPECT_TRUE(FindVotePeaks(Points(0, 3), kPeakRadius, 3).empty());
}

}  // namespace
}  // namespace musclewarp
