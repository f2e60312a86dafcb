// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/recorded_step.h"

#include <gtest/gtest.h>

#include <vector>

#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/pose_step.h"
#include "support/input_errors.h"
#include "support/prepared_small_scene.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// A motion of a small scene, and the steps that it took.
class RecordedStepTest : public ::testing::Test {
 protected:
  RecordedStepTest() : scene_(PreparedSmallScene()) {
    CertifiedContactOptions options;
    options.on_step = [this](int number, const RecordedStep& step) {
      numbers_.push_back(number);
      steps_.push_back(step);
    };
    certified_ = PrepareCertifiedScene(
        scene_, SceneMeshes(scene_), options, {}, solver_, {});
    num_rest_steps_ = steps_.size();
    MoveCertified(scene_,
                  certified_,
                  FlexedPose(0.3),
                  {},
                  solver_,
                  certified_.rest,
                  Settling::kIfPushed,
                  {});
  }

  // Takes a step that was recorded, with the scene as it was then.
  ContactState TakenAgain(const RecordedStep& step) const {
    CertifiedScene certified = certified_;
    if (step.IsOfRestPose()) certified.rest.held.clear();
    const PreRotationOptions pre_rotation;
    const MotionContext context = {scene_, certified, pre_rotation, solver_};
    return TakeStep(context,
                    {step.OptionsIn(certified.options.step),
                     step.pose,
                     step.is_settling,
                     step.max_push,
                     step.is_still,
                     step.reaches},
                    step.before,
                    StepSolves(2))
        .state;
  }

  const PreparedScene scene_;
  const MuscleSolver solver_ = ReferenceSolvers().single;
  CertifiedScene certified_;
  std::vector<int> numbers_;
  std::vector<RecordedStep> steps_;
  size_t num_rest_steps_ = 0;
};

TEST_F(RecordedStepTest, StepsAreCountedInTheRestPoseAndInEveryFrame) {
  ASSERT_GE(num_rest_steps_, 1u);
  ASSERT_GT(steps_.size(), num_rest_steps_);
  for (size_t i = 0; i < steps_.size(); ++i) {
    const bool is_rest = i < num_rest_steps_;
    EXPECT_EQ(numbers_[i], i + 1 - (is_rest ? 0 : num_rest_steps_));
    EXPECT_EQ(steps_[i].IsOfRestPose(), is_rest);
  }
}

TEST_F(RecordedStepTest, AStepFromAFileEndsInTheSameStateToTheLastBit) {
  const std::string path = TestTempDir() + "/step";
  for (const RecordedStep& step : steps_) {
    WriteRecordedStep(path, step);
    const RecordedStep read = ReadRecordedStep(path);
    EXPECT_EQ(read.before.points, step.before.points);
    const ContactState after = TakenAgain(read);
    EXPECT_EQ(after.points, step.after.points);
    EXPECT_EQ(after.targets, step.after.targets);
    EXPECT_EQ(after.coarse, step.after.coarse);
    EXPECT_EQ(after.free_coarse, step.after.free_coarse);
  }
}

TEST_F(RecordedStepTest, RefusesOtherFilesAndDamagedOnes) {
  const std::string path = TestTempDir() + "/step";
  WriteTextAtomically(path, "solid cube\n");
  ExpectInputError([&] { ReadRecordedStep(path); },
                   {path, "no recorded step", "record_steps"});
  WriteRecordedStep(path, steps_[0]);
  std::string bytes = ReadFile(path);
  bytes[bytes.size() / 2] ^= 1;
  WriteTextAtomically(path, bytes);
  ExpectInputError([&] { ReadRecordedStep(path); }, {path, "is damaged"});
  WriteTextAtomically(path, bytes.substr(0, 20));
  ExpectInputError([&] { ReadRecordedStep(path); }, {path, "is damaged"});
}

}  // namespace
}  // namespace musclewarp
