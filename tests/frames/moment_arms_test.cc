// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/moment_arms.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "frames/frame_arms.h"
#include "frames/two_over_a_knee.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/preparation/scene_meshes.h"
#include "problems/single_muscle/single_muscle_solver.h"

namespace musclewarp {
namespace {

constexpr double kArmTolerance = 1e-3;  // mm by rad: what is promised

MuscleSolver TightCeres() {
  return [](const MuscleModel& model,
            const MuscleTarget& target,
            Points* coarse,
            SolverSummary* summary) {
    auto options = SingleMuscleOptions::For(MuscleFormulation::kWhitened);
    options.hard_constraint.step_tolerance = 1e-8;
    options.hard_constraint.violation_tolerance = 1e-10;
    SolveSingleMuscle(model, target, options, coarse, summary);
  };
}

TEST(AddMomentArms, AreTheSlopesOfTheLengthsWithBothSolvers) {
  const PreparedScene scene = Prepared();
  for (const MuscleSolver& solver : {TightReference(), TightCeres()}) {
    const ScenePose pose = At(scene, 0.3, -0.6);
    const auto frame = FrameWithArms(
        scene, pose, {{SolvedFree(scene, solver, pose), {}}, {}, {}});
    const std::vector<double> arms = Arms(scene, frame, "knee");
    ASSERT_EQ(arms.size(), 10u);
    // The third derivative of lengths about 25 mm from the axis adds 1e-5 mm.
    constexpr double kBeside = 1e-2;
    const std::vector<double> before = Lengths(
        scene, SolvedFree(scene, solver, At(scene, 0.3, -0.6 - kBeside)));
    const std::vector<double> after = Lengths(
        scene, SolvedFree(scene, solver, At(scene, 0.3, -0.6 + kBeside)));
    for (size_t k = 0; k < arms.size(); ++k) {
      EXPECT_NEAR(
          arms[k], -(after[k] - before[k]) / (2 * kBeside), kArmTolerance)
          << k;
    }
    // A line and four fibres of the left muscle, then those of the right one.
    for (size_t k = 0; k < 5; ++k) EXPECT_GT(std::abs(arms[k]), 2) << k;
    for (size_t k = 5; k < 10; ++k) EXPECT_EQ(arms[k], 0) << k;
    // The hip moves everything as one.
    for (const double arm : Arms(scene, frame, "hip")) EXPECT_EQ(arm, 0);
  }
}

// A straight line that the muscle follows to the letter has the moment arm of a
// straight line: its distance from the axis.
TEST(AddMomentArms, AreTheDistanceFromTheHingeForAStraightLine) {
  const PreparedScene scene = Prepared(/*skeleton_weight=*/1e4);
  for (const double knee : {-0.4, 0.0}) {
    const ScenePose pose = At(scene, 0, knee);
    const Frame frame = FrameWithArms(
        scene, pose, {{SolvedFree(scene, TightReference(), pose), {}}, {}, {}});
    // From the thigh to the shank, as seen from the axis.
    const Eigen::Vector2d from(28, 55);
    const Eigen::Vector2d to =
        Eigen::Rotation2Dd(knee) * Eigen::Vector2d(22, -55);
    const double cross = from.x() * to.y() - from.y() * to.x();
    const double distance = std::abs(cross) / (to - from).norm();
    // To positive angles the shank comes nearer in front of the axis.
    EXPECT_NEAR(frame.muscles[0].line_moment_arms.at("left").at("knee"),
                distance,
                kArmTolerance);
    EXPECT_NEAR(
        frame.path_moment_arms.at("left").at("knee"), distance, kArmTolerance);
  }
}

// With contact: planes of bones go with them, planes between muscles with both.
class MomentArmsInContact : public ::testing::Test {
 protected:
  MomentArmsInContact()
      : scene_(Prepared()),
        certified_(PrepareCertifiedScene(
            scene_, SceneMeshes(scene_), {}, {}, TightReference(), {})) {}

  // Where the left muscle presses the right one on the ball, and beside that.
  ScenePose Pressed(double lean_beside = 0) const {
    return At(scene_, 0.2, 0, lean_beside - 0.25);
  }

  CertifiedMotion Moved(const ScenePose& to, const ContactState& from) const {
    return MoveCertified(scene_,
                         certified_,
                         to,
                         {},
                         TightReference(),
                         from,
                         Settling::kIfPushed,
                         {});
  }

  Frame ArmsOf(const CertifiedMotion& motion) const {
    const ContactState& state = motion.state;
    return FrameWithArms(scene_,
                         state.pose,
                         {{ShapesOf(certified_, state).coarse, {}},
                          ContactRowsOf(certified_, state),
                          FreeCoarseOf(certified_, state)});
  }

  // Active rows on planes of bones, or between muscles.
  int ActiveRows(const CertifiedMotion& motion, bool of_bones) const {
    int count = 0;
    const auto all = ContactRowsOf(certified_, motion.state);
    const auto coarse = ShapesOf(certified_, motion.state).coarse;
    for (size_t i = 0; i < all.size(); ++i) {
      const ContactRows& contact = all[i];
      const Eigen::VectorXd depths =
          OneSidedDepths(contact.rows,
                         FineFromCoarse(scene_.muscles[i].model, contact.rows),
                         coarse[i]);
      for (int k = 0; k < contact.rows.size(); ++k) {
        count += depths[k] > 0 && contact.owners[k].IsBone() == of_bones;
      }
    }
    return count;
  }

  const PreparedScene scene_;
  const CertifiedScene certified_;
};

TEST_F(MomentArmsInContact, AreZeroForWhatMovesEverythingAsOne) {
  const CertifiedMotion motion = Moved(Pressed(), certified_.rest);
  EXPECT_GT(ActiveRows(motion, true), 0);
  EXPECT_GT(ActiveRows(motion, false), 3);
  const Frame frame = ArmsOf(motion);
  // Up to the rounding of the rates of planes.
  for (const double arm : Arms(scene_, frame, "hip")) EXPECT_NEAR(arm, 0, 1e-6);
  // Only the left muscle moves the right one, its line and its fibres.
  const std::vector<double> arms = Arms(scene_, frame, "lean");
  EXPECT_GT(Eigen::Map<const Eigen::VectorXd>(&arms[5], 5).norm(), 5);
}

// Steps from a frame to both sides of it look for planes anew and make room
// where a muscle is held back by a bone, so that their planes are not quite
// those that are held. Rounding changes lengths by 0.01 mm, contact by 0.2 mm.
TEST_F(MomentArmsInContact, AreNearTheSlopesOfSteps) {
  const CertifiedMotion before = Moved(Pressed(), certified_.rest);
  const CertifiedMotion motion = Moved(Pressed(), before.state);
  constexpr double kBeside = 1e-2;
  const auto lengths = [&](double lean) {
    const ContactState state = Moved(Pressed(lean), before.state).state;
    return Lengths(scene_, ShapesOf(certified_, state).coarse);
  };
  const std::vector<double> low = lengths(-kBeside), high = lengths(kBeside);
  const std::vector<double> arms = Arms(scene_, ArmsOf(motion), "lean");
  double slopes = 0, differences = 0;
  for (size_t k = 5; k < arms.size(); ++k) {
    const double slope = -(high[k] - low[k]) / (2 * kBeside);
    slopes += slope * slope;
    differences += (arms[k] - slope) * (arms[k] - slope);
  }
  EXPECT_GT(std::sqrt(slopes), 5);
  EXPECT_LT(std::sqrt(differences), 0.2 * std::sqrt(slopes));
}

// Rows as contact has them, of which the derivative can be told from whole
// solves.
class MomentArmsOfHeldRows : public ::testing::Test {
 protected:
  // Half-spaces that vertices of both muscles violate by 2 mm, with the planes
  // half on the right muscle and half on the left one, going with `owner`.
  void AddRows(const PlaneOwner& owner) {
    const std::vector<Points> free =
        SolvedFree(scene_, TightReference(), At(scene_, 0.2, -0.3));
    for (size_t i = 0; i < 2; ++i) {
      const MuscleModel& model = scene_.muscles[i].model;
      const Points fine = Product(model.fine_from_coarse, free[i]);
      const double side = i == 0 ? -1 : 1;
      std::vector<VertexHalfSpace> spaces;
      for (int v = 0; v < fine.rows(); v += 10) {
        if (side * (fine(v, 2) - 12.5 * side) > 0) continue;
        const Eigen::RowVector3d normal =
            Eigen::RowVector3d(0.2, 0.1, side).normalized();
        spaces.push_back({v, {normal, normal.dot(fine.row(v)) + 2}});
        contact_[i].owners.push_back(owner);
      }
      contact_[i].rows = OneSidedRowsOf(spaces, 0.3);
    }
  }

  // Solves beside the pose with rows whose planes `moved` has moved.
  template <typename Moved>
  std::vector<Points> SolvedHeld(double beside, const Moved& moved) const {
    std::vector<OneSidedRows> all;
    for (const ContactRows& contact : contact_) {
      OneSidedRows& rows = all.emplace_back(contact.rows);
      for (int k = 0; k < rows.size(); ++k) {
        const HalfSpace plane =
            moved(beside, HalfSpace{rows.normals.row(k), rows.levels[k]});
        rows.normals.row(k) = plane.normal;
        rows.levels[k] = plane.level;
      }
    }
    const ScenePose pose = At(scene_, 0.2, -0.3 + beside);
    const MuscleModels models = ModelsOf(scene_);
    const MuscleSolver solver = TightReference();
    const SolvedPose free =
        SolvePose(models, pose, {}, solver, RestState(scene_).muscles);
    return CoarseOf(
        SolveWithRows(models, free, pose, {}, solver, all, free.states).states);
  }

  template <typename Moved>
  void ExpectSlopesOfSolves(const Moved& moved) {
    const ScenePose pose = At(scene_, 0.2, -0.3);
    const std::vector<Points> free = SolvedFree(scene_, TightReference(), pose);
    const Frame frame = FrameWithArms(
        scene_, pose, {{SolvedHeld(0, moved), {}}, contact_, free});
    const auto lengths = [&](double beside) {
      return Lengths(scene_, SolvedHeld(beside, moved));
    };
    constexpr double kBeside = 1e-2;
    const std::vector<double> low = lengths(-kBeside), high = lengths(kBeside);
    const std::vector<double> arms = Arms(scene_, frame, "knee");
    for (size_t k = 0; k < arms.size(); ++k) {
      EXPECT_NEAR(arms[k], -(high[k] - low[k]) / (2 * kBeside), kArmTolerance)
          << k;
    }
    // The right muscle would stand still without the rows.
    EXPECT_GT(std::abs(arms[5]), 0.05);
  }

  const PreparedScene scene_ = Prepared();
  std::vector<ContactRows> contact_ = std::vector<ContactRows>(2);
};

TEST_F(MomentArmsOfHeldRows, GoWithABone) {
  PlaneOwner shank;
  shank.bone = 1;
  AddRows(shank);
  ExpectSlopesOfSolves([&](double beside, const HalfSpace& plane) {
    const auto place = [&](double at) {
      return At(scene_, 0.2, -0.3 + at).bodies.at("shank");
    };
    const Eigen::Matrix4d moved = place(beside) * place(0).inverse();
    const Eigen::RowVector3d normal =
        plane.normal * moved.topLeftCorner<3, 3>().transpose();
    return HalfSpace{normal,
                     plane.level + normal.dot(moved.topRightCorner<3, 1>())};
  });
}

}  // namespace
}  // namespace musclewarp
