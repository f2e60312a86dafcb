// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/moment_arms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/frame_measures.h"
#include "musclewarp/motion/scene_meshes.h"
#include "musclewarp/scene/model_poses.h"
#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/solver/gauss_newton.h"
#include "problems/single_muscle/single_muscle_solver.h"
#include "support/meshes.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

constexpr double kArmTolerance = 1e-3;  // mm by rad: what is promised

// Two spindles along y over a knee at (0, -400, 0) mm that turns about z, side
// by side with 1 mm between them, from the thigh to the shank, each with a line
// of the model; balls of bone at their ends. The ground carries the thigh on a
// hip that turns about z, too. Coordinates: "hip", then "knee".
Scene TwoOverAKnee() {
  std::string text = Model4(
      Joint4("PinJoint", "knee"),
      "",
      Muscle("left",
             Point4("p1", "thigh", "0.025 -0.345 -0.0125") +
                 Point4("p2", "thigh", "0.025 -0.38 -0.0125") +
                 Point4("p3", "shank", "0.025 -0.02 -0.0125") +
                 Point4("p4", "shank", "0.025 -0.055 -0.0125")) +
          Muscle("right",
                 Point4("p1", "thigh", "0.028 -0.345 0.0125") +
                     Point4("p4", "shank", "0.022 -0.055 0.0125")));
  const std::string weld = "<WeldJoint name=\"hip\">";
  text.replace(text.find(weld), weld.size(), "<PinJoint name=\"hip\">");
  text.replace(text.find("</WeldJoint>"),
               12,
               "<coordinates><Coordinate name=\"hip\"/></coordinates>"
               "</PinJoint>");
  const std::string file = Written("leg.osim", text);
  ModelRest rest;
  rest.coordinates = {{"knee", 0.0}};
  std::vector<std::string> notes;
  auto poses = std::make_shared<ModelPoses>(
      BindModel(ReadModel(file), rest, {"thigh", "shank"}, file, &notes));
  poses->muscles = {0, 1};
  poses->given_coordinates = poses->moving_coordinates = {1};
  Scene scene;
  for (const int side : {-1, 1}) {
    SceneMuscle muscle;
    muscle.name = side < 0 ? "left" : "right";
    TriangleSoup soup = Spindle(12, 60, 3);
    const Points along_z = soup.points;
    soup.points.col(1) = -along_z.col(2);
    soup.points.col(2) = along_z.col(1);
    soup = MovedBy(soup, {25, -400, 12.5 * side});
    muscle.points = soup.points;
    muscle.triangles = soup.triangles;
    muscle.lines = {LineOfMuscle(*poses, side < 0 ? 0 : 1)};
    scene.muscles.push_back(muscle);
    const TriangleSoup ball =
        MovedBy(Icosphere(9, 2), {25.0, -400.0 + 66 * side, 0});
    scene.bones.push_back(
        {side < 0 ? "shank" : "thigh", ball.points, ball.triangles});
    scene.bones.back().body = scene.bones.back().name;
  }
  scene.model = poses;
  return scene;
}

PreparedScene Prepared(double skeleton_weight = 1) {
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  options.muscle.skeleton_weight = skeleton_weight;
  options.fibres.fibres = 4;
  return PrepareScene(TwoOverAKnee(), options);
}

// Solvers whose tolerances do not show in differences of lengths.
MuscleSolver TightReference() {
  return [](const MuscleModel& model,
            const MuscleTarget& target,
            Points* coarse,
            SolverSummary* summary) {
    GaussNewtonOptions options;
    options.polish_threshold = 1e-9;
    options.volume_tolerance = 1e-11;
    SolveGaussNewton(model, target, options, coarse, summary);
  };
}

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

ScenePose At(const PreparedScene& scene, double hip, double knee) {
  const Model& model = scene.scene.model->model;
  CoordinateValues values(2);
  values[model.FindCoordinate("hip")] = hip;
  values[model.FindCoordinate("knee")] = knee;
  return PoseAt(*scene.scene.model, values);
}

// The lengths of all lines, then of all fibres, of all muscles.
std::vector<double> Lengths(const PreparedScene& scene,
                            const std::vector<Points>& coarse) {
  std::vector<double> lengths;
  for (size_t i = 0; i < coarse.size(); ++i) {
    for (const CarriedLines* lines :
         {&scene.muscles[i].lines, &scene.muscles[i].fibres}) {
      for (const Points& line : LinesAt(*lines, coarse[i])) {
        lengths.push_back(PolylineLength(line));
      }
    }
  }
  return lengths;
}

// The moment arms in the same order.
std::vector<double> Arms(const Frame& frame, const std::string& coordinate) {
  std::vector<double> all;
  for (const MuscleFrame& muscle : frame.muscles) {
    for (const auto* arms :
         {&muscle.line_moment_arms, &muscle.fibre_moment_arms}) {
      const std::vector<double>& part = arms->at(coordinate);
      all.insert(all.end(), part.begin(), part.end());
    }
  }
  return all;
}

std::vector<Points> SolvedFree(const PreparedScene& scene,
                               const MuscleSolver& solver,
                               const ScenePose& pose) {
  const SolvedPose solved =
      SolvePose(scene, pose, {}, solver, RestState(scene).muscles);
  for (const SolverSummary& summary : solved.summaries) {
    EXPECT_TRUE(summary.IsSolutionUsable()) << summary.FullReport();
  }
  return CoarseOf(solved.states);
}

Frame FrameWithArms(const PreparedScene& scene,
                    const ScenePose& pose,
                    const ConvergedShapes& shapes) {
  Frame frame;
  frame.muscles.resize(scene.muscles.size());
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    frame.muscles[i].points =
        scene.muscles[i].model.fine_from_coarse * shapes.coarse[i];
  }
  AddMomentArms(scene, pose, {}, shapes, &frame);
  EXPECT_TRUE(frame.moment_arms_converged);
  return frame;
}

TEST(AddMomentArms, AreTheSlopesOfTheLengthsWithBothSolvers) {
  const PreparedScene scene = Prepared();
  for (const MuscleSolver& solver : {TightReference(), TightCeres()}) {
    const ScenePose pose = At(scene, 0.3, -0.6);
    const Frame frame = FrameWithArms(
        scene, pose, {SolvedFree(scene, solver, pose), {}, {}});
    const std::vector<double> arms = Arms(frame, "knee");
    ASSERT_EQ(arms.size(), 10u);
    // The third derivative of lengths about 25 mm from the axis adds 1e-5 mm.
    constexpr double kBeside = 2e-3;
    const std::vector<double> before = Lengths(
        scene, SolvedFree(scene, solver, At(scene, 0.3, -0.6 - kBeside)));
    const std::vector<double> after = Lengths(
        scene, SolvedFree(scene, solver, At(scene, 0.3, -0.6 + kBeside)));
    for (size_t k = 0; k < arms.size(); ++k) {
      EXPECT_NEAR(
          arms[k], -(after[k] - before[k]) / (2 * kBeside), kArmTolerance)
          << k;
      EXPECT_GT(std::abs(arms[k]), 5) << k;
    }
    // The hip moves everything as one.
    for (const double arm : Arms(frame, "hip")) EXPECT_EQ(arm, 0);
  }
}

// A straight line that the muscle follows to the letter has the moment arm of a
// straight line: its distance from the axis.
TEST(AddMomentArms, AreTheDistanceFromTheHingeForAStraightLine) {
  const PreparedScene scene = Prepared(/*skeleton_weight=*/1e4);
  for (const double knee : {-0.4, 0.0}) {
    const ScenePose pose = At(scene, 0, knee);
    const Frame frame = FrameWithArms(
        scene, pose, {SolvedFree(scene, TightReference(), pose), {}, {}});
    // From the thigh to the shank, as seen from the axis.
    const Eigen::Vector2d from(28, 55);
    const Eigen::Vector2d to =
        Eigen::Rotation2Dd(knee) * Eigen::Vector2d(22, -55);
    const double cross = from.x() * to.y() - from.y() * to.x();
    const double distance = std::abs(cross) / (to - from).norm();
    // To positive angles the shank comes nearer in front of the axis. The
    // samples end 5 mm before the ends of the line.
    EXPECT_NEAR(frame.muscles[1].line_moment_arms.at("knee")[0],
                frame.path_moment_arms.at("right").at("knee"),
                kArmTolerance);
    EXPECT_NEAR(std::abs(frame.path_moment_arms.at("right").at("knee")),
                distance,
                kArmTolerance);
  }
}

// With contact: planes of bones go with them, planes between muscles with both.
class MomentArmsInContact : public ::testing::Test {
 protected:
  MomentArmsInContact()
      : scene_(Prepared()),
        certified_(PrepareCertifiedScene(
            scene_, SceneMeshes(scene_), {}, {}, TightReference(), {})) {}

  CertifiedMotion Moved(double hip, double knee, const SceneState& before) {
    return MoveCertified(scene_,
                         certified_,
                         At(scene_, hip, knee),
                         {},
                         TightReference(),
                         before,
                         {});
  }

  Frame ArmsIn(double hip, double knee, const CertifiedMotion& motion) {
    return FrameWithArms(scene_,
                         At(scene_, hip, knee),
                         {CoarseOf(motion.state.muscles),
                          motion.contact,
                          motion.state.free_coarse});
  }

  // Active rows on planes of bones, or between muscles.
  int ActiveRows(const CertifiedMotion& motion, bool of_bones) const {
    int count = 0;
    for (size_t i = 0; i < motion.contact.size(); ++i) {
      const ContactRows& contact = motion.contact[i];
      const Eigen::VectorXd depths = OneSidedDepths(
          contact.rows,
          FineFromCoarse(scene_.muscles[i].model, contact.rows),
          motion.state.muscles[i].coarse);
      for (int k = 0; k < contact.rows.size(); ++k) {
        count += depths[k] > 0 && contact.carriers[k].IsBone() == of_bones;
      }
    }
    return count;
  }

  const PreparedScene scene_;
  const CertifiedScene certified_;
};

TEST_F(MomentArmsInContact, AreZeroForWhatMovesEverythingAsOne) {
  const CertifiedMotion motion = Moved(0.3, -0.9, certified_.rest);
  EXPECT_GT(ActiveRows(motion, true), 3);
  EXPECT_GT(ActiveRows(motion, false), 3);
  const Frame frame = ArmsIn(0.3, -0.9, motion);
  for (const double arm : Arms(frame, "hip")) {
    EXPECT_NEAR(arm, 0, 1e-6);  // rounding of the rates of planes
  }
  for (const double arm : Arms(frame, "knee")) EXPECT_GT(std::abs(arm), 1);
}

// Steps from a frame to both sides of it find their planes anew, which are not
// quite those of the frame; but what a plane goes along with shows.
TEST_F(MomentArmsInContact, AreNearTheSlopesOfSteps) {
  const CertifiedMotion motion = Moved(0, -0.9, certified_.rest);
  const CertifiedMotion here = Moved(0, -0.9, motion.state);
  const std::vector<double> arms = Arms(ArmsIn(0, -0.9, here), "knee");
  constexpr double kBeside = 1e-3;
  const std::vector<double> before = Lengths(
      scene_, CoarseOf(Moved(0, -0.9 - kBeside, motion.state).state.muscles));
  const std::vector<double> after = Lengths(
      scene_, CoarseOf(Moved(0, -0.9 + kBeside, motion.state).state.muscles));
  for (size_t k = 0; k < arms.size(); ++k) {
    std::cerr << k << " " << arms[k] << " "
              << -(after[k] - before[k]) / (2 * kBeside) << "\n";
    EXPECT_NEAR(arms[k], -(after[k] - before[k]) / (2 * kBeside), 0.1) << k;
  }
}

}  // namespace
}  // namespace musclewarp
