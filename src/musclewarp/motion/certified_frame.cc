// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_frame.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/certificate/scene_intersections.h"

namespace musclewarp {
namespace {

// " around (x, y, z)", the middle of the triangles of the muscle that cross.
std::string WhereCrossing(const PreparedScene& scene,
                          const Frame& frame,
                          const PairIntersection& pair) {
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    if (model.name != pair.a || pair.triangles_of_a.empty()) continue;
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (const int f : pair.triangles_of_a) {
      for (const int v : model.fine_triangles.row(f)) {
        middle += frame.muscles[i].fine.row(v);
      }
    }
    middle /= 3 * static_cast<double>(pair.triangles_of_a.size());
    std::ostringstream text;
    text.precision(1);
    text << std::fixed << " around (" << middle[0] << ", " << middle[1] << ", "
         << middle[2] << ")";
    return text.str();
  }
  return "";
}

}  // namespace

std::vector<std::string> Shortcomings(const PreparedScene& scene,
                                      const CertifiedContact& contact,
                                      const Frame& frame) {
  std::vector<std::string> shortcomings;
  const auto say = [&](const auto&... words) {
    std::ostringstream text;
    text.precision(3);
    (text << ... << words);
    shortcomings.push_back(text.str());
  };
  for (const PairIntersection& pair : frame.intersections.pairs) {
    if (pair.triangle_pairs + pair.vertices_inside == 0) continue;  // exempt
    say(pair.a,
        " x ",
        pair.b,
        ": ",
        pair.triangle_pairs,
        " crossing triangle pairs",
        WhereCrossing(scene, frame, pair),
        ", ",
        pair.vertices_inside,
        " vertices inside, ",
        pair.max_depth_mm,
        " mm deep");
  }
  for (size_t k = 0; k < contact.order.size(); ++k) {
    const int i = contact.order[k];
    const MuscleFrame& muscle = frame.muscles[i];
    const MuscleModel& model = scene.muscles[i].model;
    const double error = std::abs(muscle.volume_ratio - 1);
    if (!(error <= kMaxVolumeError)) {
      say(model.name, ": volume off by ", error, ", allowed ", kMaxVolumeError);
    }
    const int self_pairs = contact.muscles[k].self_pairs;
    if (muscle.self_pairs > self_pairs) {
      say(model.name,
          ": ",
          muscle.self_pairs,
          " self-intersecting triangle pairs, at rest ",
          self_pairs);
    }
    const auto most_folded = static_cast<int>(
        kMaxFoldedShare * static_cast<double>(model.fine_triangles.rows()));
    if (muscle.folded_triangles > most_folded) {
      say(model.name,
          ": ",
          muscle.folded_triangles,
          " folded triangles, allowed ",
          most_folded);
    }
    const double farthest =
        kDisplacementPerDepth * muscle.depth_without_contact +
        kDisplacementAllowance;
    if (!(muscle.max_contact_displacement <= farthest)) {
      say(model.name,
          ": moved by ",
          muscle.max_contact_displacement,
          " mm by contact, allowed ",
          farthest,
          " (",
          muscle.depth_without_contact,
          " mm deep without)");
    }
  }
  return shortcomings;
}

Frame SolveCertifiedFrame(const PreparedScene& scene,
                          const CertifiedContact& contact,
                          int index,
                          const FrameOptions& options,
                          const GroupSolver& solver,
                          SceneMeshes* meshes,
                          SceneState* state) {
  const Stopwatch moving;
  Frame frame;
  frame.index = index;
  frame.pose = &scene.scene.poses[index];
  SceneState reached = state ? *state : contact.rest;
  CertifiedWay way = MoveCertified(
      scene, contact, *frame.pose, options.pre_rotation, solver, &reached);
  frame.pose_steps = way.steps;
  frame.wall_ms = moving.Milliseconds();
  frame.solve_ms = frame.wall_ms;

  const Stopwatch certifying;
  MeasureFrame(scene,
               *frame.pose,
               reached.muscles,
               std::move(way.summaries),
               meshes,
               &frame);
  std::vector<Points> without_contact(frame.muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    without_contact[i] =
        FinePoints(scene.muscles[i].model, {reached.free_coarse[i], {}});
  }
  meshes->MoveTo(without_contact, frame.bones);
  const std::vector<double> depths =
      PenetrationDepths(meshes->muscles(), meshes->bones());
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    MuscleFrame& muscle = frame.muscles[i];
    const Eigen::VectorXd moves =
        (muscle.fine - without_contact[i]).rowwise().norm();
    muscle.max_contact_displacement = moves.maxCoeff();
    muscle.mean_contact_displacement = moves.mean();
    muscle.depth_without_contact = depths[i];
  }
  frame.shortcomings = Shortcomings(scene, contact, frame);
  frame.certify_ms = certifying.Milliseconds();
  if (state) *state = std::move(reached);
  return frame;
}

SceneIntersections CertifiedRestIntersections(const PreparedScene& scene,
                                              const CertifiedContact& contact,
                                              SceneMeshes* meshes) {
  std::vector<Points> muscles;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    muscles.push_back(
        FinePoints(scene.muscles[i].model, contact.rest.muscles[i]));
  }
  meshes->MoveTo(muscles, BonesIn(scene, contact.rest.pose));
  return IntersectScene(meshes->muscles(), meshes->bones(), scene.exempt);
}

}  // namespace musclewarp
