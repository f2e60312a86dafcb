// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/dropped_piece_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

RepairReport With(const std::vector<DroppedPiece>& pieces) {
  RepairReport report;
  report.dropped_pieces = pieces;
  return report;
}

TEST(DroppedPieceWarnings, NameEveryPieceWithItsMeasuresAndPlace) {
  EXPECT_THAT(
      DroppedPieceWarnings(
          "biceps",
          With({{DropReason::kSmaller, 960, 4310, 0.38, 26700, {1, 2, 3.04}}})),
      ElementsAre(
          "biceps: a piece of 43.1 cm2, 38 % of its surface, 26.7 cm3 around "
          "(1.0, 2.0, 3.0) is left out: a muscle is one closed surface "
          "(separation with {pieces}=all makes a mesh of each piece)"));
}

TEST(DroppedPieceWarnings, CountCrumbsTogether) {
  const DroppedPiece small = {DropReason::kCrumb, 8, 10, 0.001, 1, {0, 0, 0}};
  const DroppedPiece large = {DropReason::kCrumb, 9, 30, 0.003, 9, {7, 0, 0}};
  EXPECT_THAT(
      DroppedPieceWarnings("foot", With({small, large})),
      ElementsAre("foot: 2 crumbs of together 0.4 cm2, 0.4 % of its surface, "
                  "0.01 cm3 are left out, the largest around (7.0, 0.0, 0.0)"));
}

// A ball of 0.5 mm in a muscle is in its way, however large the bone.
TEST(DroppedPieceWarnings, NameATinyBody) {
  EXPECT_THAT(
      DroppedPieceWarnings(
          "spine",
          With({{DropReason::kCrumb, 80, 3.1, 1e-7, 0.5, {34, 0, 100}}})),
      ElementsAre("spine: 1 crumb of 0.031 cm2, 1e-05 % of its surface, "
                  "0.0005 cm3 is left out, around (34.0, 0.0, 100.0)"));
}

TEST(DroppedPieceWarnings, PassOverAFlap) {
  EXPECT_THAT(DroppedPieceWarnings(
                  "femur",
                  With({{DropReason::kCrumb, 1, 0.1, 1e-6, 0, {0, 0, 0}},
                        {DropReason::kFlat, 2, 0.1, 1e-6, 0, {0, 0, 0}}})),
              IsEmpty());
}

}  // namespace
}  // namespace musclewarp
