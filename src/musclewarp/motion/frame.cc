// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/frame.h"

#include <memory>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/dense_product.h"
#include "musclewarp/geometry/folded_triangles.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

double PolylineLength(const Points& points) {
  const Eigen::Index segments = points.rows() - 1;
  return (points.bottomRows(segments) - points.topRows(segments))
      .rowwise()
      .norm()
      .sum();
}

MuscleFrame SolveMuscle(const MuscleModel& model,
                        const ScenePose& pose,
                        const PreRotationOptions& pre_rotation,
                        const MuscleSolver& solver) {
  MuscleFrame frame;
  Points coarse = model.coarse_rest;
  solver(model, TargetOf(model, pose, pre_rotation), &coarse, &frame.solver);
  frame.fine = Product(model.fine_from_coarse, coarse);
  frame.volume_ratio =
      SignedVolume(frame.fine, model.fine_triangles) / model.rest_volume;
  frame.max_displacement =
      (frame.fine - model.fine_rest).rowwise().norm().maxCoeff();
  const std::vector<LineTarget> targets = LineTargets(model.lines, pose);
  for (size_t i = 0; i < targets.size(); ++i) {
    frame.line_lengths[model.lines[i].name] = PolylineLength(targets[i].points);
  }
  return frame;
}

SceneIntersections Intersect(const PreparedScene& scene,
                             const std::vector<const Points*>& muscles,
                             const std::vector<const Points*>& bones) {
  std::vector<std::unique_ptr<SearchableMesh>> meshes;
  const auto add = [&](const std::string& name,
                       const Points& points,
                       const Triangles& triangles) {
    meshes.push_back(
        std::make_unique<SearchableMesh>(TriangleSoup{points, triangles}));
    return NamedMesh{name, meshes.back().get()};
  };
  std::vector<NamedMesh> named_muscles;
  for (size_t i = 0; i < muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    named_muscles.push_back(add(model.name, *muscles[i], model.fine_triangles));
  }
  std::vector<NamedMesh> named_bones;
  for (size_t i = 0; i < bones.size(); ++i) {
    named_bones.push_back(add(
        scene.bones[i].mesh.name, *bones[i], scene.bones[i].rest.triangles));
  }
  return IntersectScene(named_muscles, named_bones);
}

}  // namespace

int Frame::iterations() const {
  int sum = 0;
  for (const MuscleFrame& muscle : muscles) sum += muscle.solver.iterations;
  return sum;
}

std::string Frame::stop_reason(const PreparedScene& scene) const {
  for (size_t i = 0; i < muscles.size(); ++i) {
    if (muscles[i].solver.stop_reason == StopReason::kConverged) continue;
    return ToString(muscles[i].solver.stop_reason) + " (" +
           scene.muscles[i].model.name + ")";
  }
  return ToString(StopReason::kConverged);
}

bool Frame::IsUsable() const {
  for (const MuscleFrame& muscle : muscles) {
    if (!muscle.solver.IsSolutionUsable()) return false;
  }
  return true;
}

Frame SolveFrame(const PreparedScene& scene,
                 int index,
                 const PreRotationOptions& pre_rotation,
                 const MuscleSolver& solver) {
  const Stopwatch solving;
  Frame frame;
  frame.index = index;
  frame.pose = &scene.scene.poses[index];
  frame.muscles.resize(scene.muscles.size());
  const int muscle_count = static_cast<int>(scene.muscles.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < muscle_count; ++i) {
    frame.muscles[i] =
        SolveMuscle(scene.muscles[i].model, *frame.pose, pre_rotation, solver);
  }
  for (const PreparedBone& bone : scene.bones) {
    frame.bones.push_back(
        Transformed(bone.rest.points, BodyTransform(*frame.pose, bone.body)));
  }
  frame.wall_ms = solving.Milliseconds();

  const Stopwatch certifying;
  std::vector<const Points*> muscles;
  std::vector<const Points*> bones;
  for (int i = 0; i < muscle_count; ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    frame.muscles[i].folded_triangles = static_cast<int>(
        FoldedTriangles(
            model.fine_rest, frame.muscles[i].fine, model.fine_triangles)
            .size());
    muscles.push_back(&frame.muscles[i].fine);
  }
  for (const Points& bone : frame.bones) bones.push_back(&bone);
  frame.intersections = Intersect(scene, muscles, bones);
  frame.certify_ms = certifying.Milliseconds();
  return frame;
}

SceneIntersections RestIntersections(const PreparedScene& scene) {
  std::vector<const Points*> muscles;
  std::vector<const Points*> bones;
  for (const auto& muscle : scene.muscles) {
    muscles.push_back(&muscle.model.fine_rest);
  }
  for (const auto& bone : scene.bones) bones.push_back(&bone.rest.points);
  return Intersect(scene, muscles, bones);
}

}  // namespace musclewarp
