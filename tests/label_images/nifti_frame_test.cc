// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nifti_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/made_images.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(NoteOnOtherQform, IsThereFromATenthOfAVoxelOn) {
  const Eigen::Array3i size(101, 50, 20);
  const Eigen::Matrix4d sform = TurnedSteps({2, 2, 4}, {10, -20, 30});
  EXPECT_EQ(NoteOnOtherQform("a.nii", size, sform, sform), "");
  Eigen::Matrix4d moved = sform;
  moved(0, 3) += 0.19;
  EXPECT_EQ(NoteOnOtherQform("a.nii", size, sform, moved), "");
  moved(0, 3) += 0.02;
  EXPECT_THAT(NoteOnOtherQform("a.nii", size, sform, moved),
              AllOf(HasSubstr("a.nii has an sform and a qform"),
                    HasSubstr("0.105 voxels"),
                    HasSubstr("the sform is taken")));
  // A small turn is large at the other end.
  Eigen::Matrix4d longer = sform;
  longer.col(0) *= 1.002;
  EXPECT_THAT(NoteOnOtherQform("a.nii", size, sform, longer),
              HasSubstr("0.2 voxels"));
}

}  // namespace
}  // namespace musclewarp
