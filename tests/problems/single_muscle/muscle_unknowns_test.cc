// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/muscle_unknowns.h"

#include <gtest/gtest.h>

#include "problems/single_muscle/term_checks.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// Through U and back, of coordinates of size 100, mm.
constexpr double kRoundTripRounding = 1e-9;

class MuscleUnknownsTest : public ::testing::TestWithParam<MuscleFormulation> {
 protected:
  double Distance(const Points& a, const Points& b) const {
    return (a - b).cwiseAbs().maxCoeff();
  }

  const MuscleModel model_ = SpindleModel();
  const MuscleTarget target_ = TargetOf(model_, BentPose(0.5), {});
  const int count_ = static_cast<int>(model_.coarse_rest.rows());
  const Points start_ = model_.coarse_rest + RandomPoints(count_);
};

TEST_P(MuscleUnknownsTest, GiveBackTheCoarseVerticesThatWereSet) {
  MuscleUnknowns unknowns(model_, target_, GetParam(), start_);
  EXPECT_LT(Distance(unknowns.Coarse(), start_), kRoundTripRounding);
  unknowns.SetCoarse(model_.coarse_rest);
  EXPECT_LT(Distance(unknowns.Coarse(), model_.coarse_rest),
            kRoundTripRounding);
}

TEST_P(MuscleUnknownsTest, BlocksAreTheRowsOfTheValues) {
  MuscleUnknowns unknowns(model_, target_, GetParam(), start_);
  const std::vector<double*> blocks = unknowns.Blocks();
  ASSERT_EQ(unknowns.num_blocks(), count_);
  ASSERT_EQ(unknowns.size(), 3 * count_);
  ASSERT_EQ(blocks.size(), static_cast<size_t>(count_));
  for (int i = 0; i < count_; ++i) {
    EXPECT_EQ(blocks[i], unknowns.data() + 3 * i);
  }
  const Points values = Eigen::Map<const Points>(unknowns.data(), count_, 3);
  EXPECT_EQ(unknowns.CoarseOf(TermBlocks(values).data()),
            Points(unknowns.Coarse()));
  // What Ceres writes to a block is seen.
  blocks[3][1] += 1;
  EXPECT_GT(Distance(unknowns.Coarse(), start_), 0.01);
}

TEST_P(MuscleUnknownsTest, RememberNothingWrong) {
  MuscleUnknowns unknowns(model_, target_, GetParam(), start_);
  const Points a = RandomPoints(count_);
  const Points b = 2 * a;
  const Points of_a = unknowns.CoarseOf(a);
  const Points of_b = unknowns.CoarseOf(b);
  EXPECT_NE(of_a, of_b);
  EXPECT_EQ(unknowns.CoarseOf(a), of_a);
  EXPECT_EQ(unknowns.CoarseOf(a), of_a);
  EXPECT_EQ(unknowns.CoarseOf(b), of_b);
}

TEST_P(MuscleUnknownsTest, RowsAndGradientsAreDerivativesOfTheCoarseVertices) {
  MuscleUnknowns unknowns(model_, target_, GetParam(), start_);
  const Points values = Eigen::Map<const Points>(unknowns.data(), count_, 3);
  const Points step = RandomPoints(count_);
  const Points before = unknowns.CoarseOf(values);
  const Points after = unknowns.CoarseOf(values + step);
  // X is an affine function of the values: differences are exact.
  const RowMajorMatrix rows = model_.skeleton;
  const Points change = unknowns.RowsOf(rows) * step;
  EXPECT_LT(Distance(change, rows * (after - before)), kRoundTripRounding);
  EXPECT_GT(change.norm(), 1e-3);
  const Points gradient = RandomPoints(count_).array() + 1;
  const double expected = gradient.cwiseProduct(after - before).sum();
  EXPECT_NEAR(unknowns.GradientOf(gradient).cwiseProduct(step).sum(),
              expected,
              kRoundTripRounding * std::abs(expected));
}

INSTANTIATE_TEST_SUITE_P(Formulations,
                         MuscleUnknownsTest,
                         ::testing::Values(MuscleFormulation::kBlocks,
                                           MuscleFormulation::kWhitened));

}  // namespace
}  // namespace musclewarp
