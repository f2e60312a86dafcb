// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/frames/moment_arms.h"
#include "musclewarp/motion/solved_pose.h"
#include "musclewarp/scene/model_poses.h"
#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/solver/gauss_newton.h"
#include "support/meshes.h"
#include "support/osim_models.h"

namespace musclewarp {

// Two spindles along y, side by side along z with 1 mm between them, beside a
// knee at (0, -400, 0) mm. The left one goes from the thigh to the shank, along
// a straight line of the model, the right one stays on the thigh; beside
// it is a ball of bone of the thigh. The shank, a ball below, leans about x by
// "lean", with negative angles towards the right muscle, and bends about z by
// "knee". The ground carries the thigh on a hip that turns about z by "hip".
inline Scene TwoOverAKnee() {
  std::string text =
      Model4(Joint4("GimbalJoint", "lean twist knee"),
             "",
             Muscle("left",
                    Point4("p1", "thigh", "0.028 -0.345 -0.0125") +
                        Point4("p2", "shank", "0.022 -0.055 -0.0125")) +
                 Muscle("right",
                        Point4("p1", "thigh", "0.025 -0.345 0.0125") +
                            Point4("p2", "thigh", "0.025 -0.455 0.0125")));
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
  poses->moving_coordinates = {poses->model.FindCoordinate("knee")};
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
  }
  const TriangleSoup thigh = MovedBy(Icosphere(12, 2), {25, -420, 35.6});
  const TriangleSoup shank = MovedBy(Icosphere(9, 2), {25, -475, 0});
  scene.bones.push_back({"thigh", thigh.points, thigh.triangles});
  scene.bones.push_back({"shank", shank.points, shank.triangles});
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  scene.model = poses;
  return scene;
}

inline PreparedScene Prepared(double skeleton_weight = 1,
                              const Scene& scene = TwoOverAKnee()) {
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  options.muscle.skeleton_weight = skeleton_weight;
  options.fibres.fibres = 4;
  return PrepareScene(scene, options);
}

// Solvers whose tolerances do not show in differences of lengths.
inline MuscleSolver TightReference() {
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

inline ScenePose At(const PreparedScene& scene,
                    double hip,
                    double knee,
                    double lean = 0) {
  const Model& model = scene.scene.model->model;
  CoordinateValues values = DefaultValues(model);
  values[model.FindCoordinate("hip")] = hip;
  values[model.FindCoordinate("knee")] = knee;
  values[model.FindCoordinate("lean")] = lean;
  return PoseAt(*scene.scene.model, values);
}

// The lengths of all lines, then of all fibres, of all muscles.
inline std::vector<double> Lengths(const PreparedScene& scene,
                                   const std::vector<Points>& coarse) {
  std::vector<double> lengths;
  for (size_t i = 0; i < coarse.size(); ++i) {
    for (const EmbeddedLines* lines :
         {&scene.muscles[i].lines, &scene.muscles[i].fibres}) {
      for (const Points& line : LinesAt(*lines, coarse[i])) {
        lengths.push_back(PolylineLength(line));
      }
    }
  }
  return lengths;
}

inline std::vector<Points> SolvedFree(const PreparedScene& scene,
                                      const MuscleSolver& solver,
                                      const ScenePose& pose) {
  const SolvedPose solved =
      SolvePose(ModelsOf(scene), pose, {}, solver, RestState(scene).muscles);
  for (const SolverSummary& summary : solved.summaries) {
    EXPECT_TRUE(summary.IsSolutionUsable()) << summary.FullReport();
  }
  return CoarseOf(solved.states);
}

inline Frame FrameWithArms(const PreparedScene& scene,
                           const ScenePose& pose,
                           ConvergedShapes shapes) {
  Frame frame;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    frame.muscles.emplace_back().points = Product(
        scene.muscles[i].model.fine_from_coarse, shapes.muscles.coarse[i]);
    shapes.muscles.fine.push_back(frame.muscles[i].points);
  }
  AddMomentArms(scene, pose, {}, shapes, &frame);
  EXPECT_TRUE(frame.moment_arms_converged);
  return frame;
}

}  // namespace musclewarp
